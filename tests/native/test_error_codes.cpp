// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the codes, listed elements and messages of errors.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "base/planar.h"
#include "error_of.h"
#include "newton/solve/chart_errors.h"
#include "test_meshes.h"

namespace wirewarp::test_error_codes {
namespace {

using Code = ErrorCode;
using test::expect_words;

const std::vector<std::array<double, 3>> kPoints{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};

FlattenInput triangles(const std::vector<std::array<int, 3>>& faces) { return test::mesh_of(kPoints, faces); }

/// Returns a unit square, divided along the diagonal from vertex 0 to vertex 2.
FlattenInput square() { return triangles({{0, 1, 2}, {0, 2, 3}}); }

FlattenInput with_wire(const std::vector<int>& chain, double tolerance = 0) {
  FlattenInput input = square();
  test::add_wire(input, chain, tolerance, "bust");
  return input;
}

FlattenInput with_seam(const std::vector<int>& chain) {
  FlattenInput input = square();
  test::add_seam(input, chain);
  return input;
}

FlattenInput with_coordinate(double value) {
  FlattenInput input = square();
  input.vertices(2, 1) = value;
  return input;
}

FlattenInput scaled(FlattenInput input, double factor) {
  input.vertices *= factor;
  return input;
}

FlattenInput loose_squares(int count, int triangles_of_each) {
  FlattenInput input;
  input.vertices.resize(4 * count, 3);
  input.faces.resize(triangles_of_each * count, 3);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 4; ++k) input.vertices.row(4 * i + k) << i + (k == 1 || k == 2), (k > 1 ? 1 : 0), 0;
    for (int k = 0; k < triangles_of_each; ++k) {
      input.faces.row(triangles_of_each * i + k) << 4 * i, 4 * i + k + 1, 4 * i + k + 2;
    }
  }
  return input;
}

struct Fault {
  FlattenInput input;
  Code code;
  const char* words;
  // The error must list these elements. Empty lists are not compared.
  std::vector<int> faces = {};
  std::vector<int> vertices = {};
  std::vector<VertexPair> edges = {};
};

void expect_fault(const FlattenError& error, const Fault& fault) {
  SCOPED_TRACE(fault.words);
  EXPECT_EQ(error.code, fault.code);
  expect_words(error, fault.words);
  const auto expect_listed = [](const auto& found, const auto& expected) {
    EXPECT_TRUE(expected.empty() || found == expected);
  };
  expect_listed(error.elements.faces, fault.faces);
  expect_listed(error.elements.vertices, fault.vertices);
  expect_listed(error.elements.edges, fault.edges);
}

const double kInfinity = std::numeric_limits<double>::infinity(), kNan = std::nan("");

TEST(ErrorCodes, FaultsOfTheInputAreThrown) {
  FlattenInput two_wires = with_wire({0, 2});
  test::add_wire(two_wires, {2, 0});
  for (const Fault& fault : std::vector<Fault>{
           {{}, Code::empty_mesh, ""},
           {triangles({{0, 1, 2}, {0, 2, 7}}), Code::vertex_out_of_range, "Face 1 names vertex 7,", {1}, {7}},
           {triangles({{0, 7, 2}, {0, 9, 7}}),
            Code::vertex_out_of_range,
            "Faces 0 and 1 name vertices 7 and 9,",
            {0, 1},
            {7, 9}},
           {with_seam({0, 99}), Code::vertex_out_of_range, "99"},
           {with_wire({0, -1}), Code::vertex_out_of_range, "-1"},
           {with_coordinate(kNan), Code::non_finite_coordinates, "vertex 2", {}, {2}},
           {with_coordinate(kInfinity), Code::non_finite_coordinates, "vertex 2", {}, {2}},
           {with_coordinate(1e60), Code::non_finite_coordinates, "vertex 2", {}, {2}},
           {with_coordinate(-1e200), Code::non_finite_coordinates, "vertex 2", {}, {2}},
           {with_seam({1, 3}), Code::seam_not_an_edge, "edge 1-3", {}, {}, {{1, 3}}},
           {with_wire({0, 1, 3}), Code::wire_not_an_edge, "wire 0 (bust)", {}, {}, {{1, 3}}},
           {with_wire({2}), Code::wire_too_short, "(bust)"},
           {with_wire({0, 2, 0}), Code::edge_in_two_wires, "0"},
           {two_wires, Code::edge_in_two_wires, "", {}, {}, {{2, 0}}},
           {with_wire({0, 2}, -0.01), Code::invalid_tolerance, "(bust)"},
           {with_wire({0, 2}, kNan), Code::invalid_tolerance, "(bust)"},
       }) {
    expect_fault(test::error_of([&] { flatten(fault.input); }), fault);
  }
}

FlattenError carried_by(const FlattenInput& input, Code code) {
  return test::expect_error(flatten(input).pieces.at(0).error, code);
}

TEST(ErrorCodes, FaultsOfAPieceAreReportedWithThePiece) {
  const FlattenInput flat_face = test::mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const FlattenInput three_faces = triangles({{0, 1, 2}, {0, 2, 3}, {0, 2, 4}});
  const FlattenInput pyramid = triangles({{0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {0, 4, 2}});
  for (const Fault& fault : std::vector<Fault>{
           {scaled(square(), 1e-61), Code::zero_area_face, "", {0, 1}},  // areas below the smallest double
           {triangles({{0, 1, 2}, {0, 2, 2}}), Code::repeated_vertex_in_face, "Face 1", {1}},
           {triangles({{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}), Code::repeated_face, "Face 2", {2}},
           {flat_face, Code::zero_area_face, "Face 0", {0}},
           {three_faces, Code::non_manifold_edge, "edge 0-2", {}, {}, {{0, 2}}},
           {triangles({{0, 1, 2}, {0, 3, 2}}),
            Code::inconsistent_orientation,
            "recalculate the normals",
            {},
            {},
            {{0, 2}}},
           {pyramid, Code::closed_chart, "is closed: mark a seam that opens it, such as along edge", {0, 1, 2, 3}},
       }) {
    expect_fault(carried_by(fault.input, fault.code), fault);
  }
}

TEST(ErrorCodes, SeamsAreProposedIfNothingElseHelps) {
  const FlattenError three_faces = carried_by(triangles({{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}), Code::non_manifold_edge);
  EXPECT_EQ(three_faces.elements.proposed_seams, three_faces.elements.edges);
  const FlattenError flipped = carried_by(triangles({{0, 1, 2}, {0, 3, 2}}), Code::inconsistent_orientation);
  EXPECT_TRUE(flipped.elements.proposed_seams.empty()) << "flip a face instead";
}

TEST(ErrorCodes, LooseFacesAreMoreThanAThousandSeparateParts) {
  const auto refused = [](int count, int triangles_of_each) {
    const FlattenError error = test::error_of([&] { flatten(loose_squares(count, triangles_of_each)); });
    EXPECT_EQ(error.code, Code::loose_faces);
    return error;
  };
  const FlattenError triangles = refused(1001, 1);
  expect_words(triangles,
               "The 1001 triangles of the mesh are 1001 separate parts, such as faces 0, 1, 2, 3, 4 and 996 "
               "more: merge vertices by distance");
  EXPECT_EQ(triangles.elements.faces.size(), 1001U);
  expect_words(refused(1001, 2), "The 2002 triangles of the mesh are 1001 separate parts");
  const FlattenResult allowed = flatten(loose_squares(1000, 1));
  EXPECT_EQ(allowed.pieces.size(), 1000U);
  EXPECT_FALSE(allowed.pieces.front().error);
}

TEST(ErrorCodes, TheScaleOfTheModelDoesNotMatter) {
  FlattenInput saddle = test::saddle(6, 0.4);  // rounding errors change its shape little, because nothing buckles
  test::add_wire(saddle, test::grid_row(6, 2));
  const Positions2 expected = flatten(saddle).pieces[0].vertices;
  for (const double scale : {1e-57, 0.9e60}) {
    const FlattenResult result = flatten(scaled(saddle, scale));
    ASSERT_FALSE(result.pieces[0].error.has_value()) << scale << " " << result.pieces[0].error->what();
    // Rounding errors may change positions by 1e-6, because each stage stops when the next step would gain less than
    // 1e-9 of its objective.
    EXPECT_LT((result.pieces[0].vertices / scale - expected).cwiseAbs().maxCoeff(), 1e-6) << scale;
  }
}

TEST(ErrorCodes, InvalidOption) {
  const auto expect_refused = [](const std::function<void(Options&)>& change, const std::string& words) {
    Options options;
    change(options);
    const FlattenError error = test::error_of([&] { flatten(square(), options); });
    EXPECT_EQ(error.code, Code::invalid_option);
    expect_words(error, words);
  };
  for (const double bad : {-0.1, 1.5, kNan}) expect_refused([=](Options& o) { o.gap = bad; }, "gap");
  for (const int bad : {-2, 0}) expect_refused([=](Options& o) { o.grain = bad; }, "grain");  // 0: input without wires
  for (const double bad : {0.0, kNan}) expect_refused([=](Options& o) { o.up = {bad, 0, 0}; }, "up");
  for (const double bad : {0.0, 0.0009, 11.0, -0.1, kNan}) {
    expect_refused([=](Options& o) { o.fairness = bad; }, "between 0.001 and 10");
  }
  for (const int bad : {0, -3}) {
    expect_refused([=](Options& o) { o.max_factorizations = bad; }, "max_factorizations is " + std::to_string(bad));
  }
}

TEST(ErrorCodes, OptionsAndWiresAreCheckedWithoutAMeshToo) {
  Options options;
  options.grain = 5;  // allowed, because the number of wires is unknown
  EXPECT_NO_THROW(check_options(options));
  options.grain = -2;
  EXPECT_THROW(check_options(options), FlattenError);
  EXPECT_NO_THROW(check_wire({{7, 9}, 0.1, "waist"}));
  const FlattenError error = test::error_of([] { check_wire({{7}, 0.1, "waist"}); });
  EXPECT_EQ(error.code, Code::wire_too_short);
  EXPECT_TRUE(error.elements.vertices.empty()) << "there is no mesh";
  expect_words(error, "wire (waist)");
  EXPECT_THROW(check_wire({{7, 9}, -1, ""}), FlattenError);
}

TEST(ErrorCodes, CornersOfTheWrongNumberOfFaces) {
  EXPECT_EQ(test::error_of([] { measure(square(), CornerUv::Zero(5, 6)); }).code, Code::invalid_shape);
}

TEST(ErrorCodes, NonManifoldVertex) {
  // A ring of quads without its last triangle. The two ends of the ring touch only at one vertex.
  const int n = 8;
  FlattenInput input = test::flat_annulus(n, 1, 1, 2);
  const Eigen::RowVector3i left_out = input.faces.bottomRows(1);
  input.faces.conservativeResize(2 * n - 1, 3);
  const FlattenError error = carried_by(input, Code::non_manifold_vertex);
  ASSERT_EQ(error.elements.vertices.size(), 1u);
  EXPECT_TRUE((left_out.array() == error.elements.vertices[0]).any());
  expect_words(error, "vertex " + std::to_string(error.elements.vertices[0]));
}

TEST(ErrorCodes, Handles) {
  FlattenInput torus = test::closed_torus(6, 6);
  torus.faces.conservativeResize(torus.faces.rows() - 1, 3);
  expect_words(carried_by(torus, Code::handles), "such as along edges");
}

TEST(ErrorCodes, OtherChartsAreFlattenedIfOneIsNotSolvable) {
  // A pyramid of squares, each 1e-10 times as large as the square below it. The linear system is singular, because a
  // random walk leaves the inner squares with a probability below rounding errors.
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> faces;
  const int rings = 4;
  for (int ring = 0; ring < rings; ++ring) {
    const double size = std::pow(1e-10, ring);
    points.insert(points.end(), {{size, 0, -size}, {0, size, -size}, {-size, 0, -size}, {0, -size, -size}});
    if (ring == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const int outer = 4 * (ring - 1) + i, next = 4 * (ring - 1) + (i + 1) % 4;
      faces.push_back({outer, next, next + 4});
      faces.push_back({outer, next + 4, outer + 4});
    }
  }
  const int last = 4 * (rings - 1);
  faces.push_back({last, last + 1, last + 2});
  faces.push_back({last, last + 2, last + 3});
  const std::size_t num_nested = faces.size();
  points.insert(points.end(), {{5, 0, 0}, {6, 0, 0}, {6, 1, 0}});
  faces.push_back({last + 4, last + 5, last + 6});
  const FlattenResult result = flatten(test::mesh_of(points, faces));
  const FlattenError error = test::expect_error(result.pieces[0].error, Code::not_solvable);
  std::set<int> small;  // all faces without an edge on the outermost square
  for (std::size_t f = 0; f < num_nested; ++f) {
    if (f >= 8 || f % 2 == 1) small.insert(static_cast<int>(f));
  }
  EXPECT_EQ(std::set<int>(error.elements.faces.begin(), error.elements.faces.end()), small);
  expect_words(error, "differ too much in size");
  EXPECT_EQ(result.pieces[0].report.termination, Termination::failed);
  EXPECT_FALSE(result.pieces[1].error.has_value());
}

TEST(ErrorCodes, TheErrorOfWiresThatCannotBeJoinedNamesThemAndTheRefinedMethod) {
  FlattenInput input = test::flat_plate_with_two_holes(4);
  test::add_wire(input, {input.faces(0, 0), input.faces(0, 1)});
  test::add_wire(input, {input.faces(20, 1), input.faces(20, 2)});
  const Chart chart = test::charts_of(input).charts[0];
  const FlattenError error = not_joined(chart);
  EXPECT_EQ(error.code, Code::not_solvable);
  std::size_t num_edges = 0;
  for (const WirePart& part : chart.wire_parts)
    num_edges += part.kind == WireKind::boundary ? 0 : part.half_edges.size();
  for (std::size_t i = 1; i < 3; ++i) num_edges += chart.boundary_loops.at(i).size();
  EXPECT_EQ(error.elements.edges.size(), num_edges);
  expect_words(error, "use the refined method");
}

// A one-sided surface has no consistent orientation, whichever faces are flipped.
TEST(OneSidedSurface, AMobiusStripIsCutWhereFacesFlip) {
  constexpr int n = 12;
  FlattenInput strip;
  strip.vertices.resize(2 * n, 3);
  strip.faces.resize(2 * n, 3);
  for (int i = 0; i < n; ++i) {
    const double around = 2 * kPi * i / n, twist = around / 2;
    for (const int side : {0, 1}) {
      const double across = side == 0 ? -0.2 : 0.2, radius = 1 + across * std::cos(twist);
      strip.vertices.row(2 * i + side) << radius * std::cos(around), radius * std::sin(around),
          across * std::sin(twist);
    }
    const bool is_last = i + 1 == n;  // the ends are joined upside down
    const int a = 2 * i, b = 2 * i + 1, c = is_last ? 1 : a + 2, d = is_last ? 0 : b + 2;
    strip.faces.row(2 * i) << a, c, b;
    strip.faces.row(2 * i + 1) << b, c, d;
  }
  const FlattenError error = carried_by(strip, Code::inconsistent_orientation);
  expect_words(error, "one-sided");
  ASSERT_FALSE(error.elements.proposed_seams.empty());
  for (const VertexPair& pair : error.elements.proposed_seams) test::add_seam(strip, {pair[0], pair[1]});
  const FlattenResult result = flatten(strip);
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_FALSE(result.pieces[0].error) << result.pieces[0].error->what();
}

}  // namespace
}  // namespace wirewarp::test_error_codes
