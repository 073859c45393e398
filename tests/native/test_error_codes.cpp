// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that errors of the input, options and pieces have the right code, and name the faulty elements in their lists
// and messages.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
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

/// Returns `count` squares that share no vertices. Each square has one or two triangles.
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
  const char* name;
  FlattenInput input;
  Code code;
  const char* words;  // words that the message must contain
  std::vector<int> faces = {};
  std::vector<int> vertices = {};
  std::vector<VertexPair> edges = {};
};

/// Names the case in test reports.
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }
std::string name_of(const testing::TestParamInfo<Fault>& test) { return test.param.name; }

void expect_fault(const FlattenError& error, const Fault& fault) {
  EXPECT_EQ(error.code, fault.code);
  expect_words(error, fault.words);
  if (!fault.faces.empty()) {
    EXPECT_EQ(error.elements.faces, fault.faces);
  }
  if (!fault.vertices.empty()) {
    EXPECT_EQ(error.elements.vertices, fault.vertices);
  }
  if (!fault.edges.empty()) {
    EXPECT_EQ(error.elements.edges, fault.edges);
  }
}

class FaultOfTheInput : public testing::TestWithParam<Fault> {};

TEST_P(FaultOfTheInput, IsThrown) {
  expect_fault(test::error_of([] { flatten(GetParam().input); }), GetParam());
}

const double kInfinity = std::numeric_limits<double>::infinity(), kNan = std::nan("");

INSTANTIATE_TEST_SUITE_P(
    ErrorCodes, FaultOfTheInput,
    testing::Values(
        Fault{"no_mesh", {}, Code::empty_mesh, ""},
        Fault{"face_out_of_range",
              triangles({{0, 1, 2}, {0, 2, 7}}),
              Code::vertex_out_of_range,
              "Face 1 names vertex 7,",
              {1},
              {7}},
        Fault{"faces_out_of_range",
              triangles({{0, 7, 2}, {0, 9, 7}}),
              Code::vertex_out_of_range,
              "Faces 0 and 1 name vertices 7 and 9,",
              {0, 1},
              {7, 9}},
        Fault{"seam_out_of_range", with_seam({0, 99}), Code::vertex_out_of_range, "99"},
        Fault{"wire_out_of_range", with_wire({0, -1}), Code::vertex_out_of_range, "-1"},
        Fault{"nan", with_coordinate(kNan), Code::non_finite_coordinates, "vertex 2", {}, {2}},
        Fault{"infinity", with_coordinate(kInfinity), Code::non_finite_coordinates, "vertex 2", {}, {2}},
        Fault{"too_far", with_coordinate(1e60), Code::non_finite_coordinates, "vertex 2", {}, {2}},
        Fault{"too_far_down", with_coordinate(-1e200), Code::non_finite_coordinates, "vertex 2", {}, {2}},
        Fault{"seam_beside_edges", with_seam({1, 3}), Code::seam_not_an_edge, "edge 1-3", {}, {}, {{1, 3}}},
        Fault{"wire_beside_edges", with_wire({0, 1, 3}), Code::wire_not_an_edge, "wire 0 (bust)", {}, {}, {{1, 3}}},
        Fault{"short_wire", with_wire({2}), Code::wire_too_short, "(bust)"},
        Fault{"wire_there_and_back", with_wire({0, 2, 0}), Code::edge_in_two_wires, "0"},
        Fault{"negative_tolerance", with_wire({0, 2}, -0.01), Code::invalid_tolerance, "(bust)"},
        Fault{"tolerance_nan", with_wire({0, 2}, kNan), Code::invalid_tolerance, "(bust)"}),
    name_of);

class FaultOfAPiece : public testing::TestWithParam<Fault> {};

TEST_P(FaultOfAPiece, IsReportedWithThePiece) {
  const FlattenResult result = flatten(GetParam().input);
  ASSERT_TRUE(result.pieces.at(0).error);
  expect_fault(*result.pieces[0].error, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    ErrorCodes, FaultOfAPiece,
    testing::Values(
        Fault{"area_too_small_for_a_double", scaled(square(), 1e-61), Code::zero_area_face, "", {0, 1}},
        Fault{"repeated_vertex", triangles({{0, 1, 2}, {0, 2, 2}}), Code::repeated_vertex_in_face, "Face 1", {1}},
        Fault{"repeated_face", triangles({{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}), Code::repeated_face, "Face 2", {2}},
        Fault{"no_area",
              test::mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}),
              Code::zero_area_face,
              "Face 0",
              {0}},
        Fault{"three_faces_at_an_edge",
              triangles({{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}),
              Code::non_manifold_edge,
              "edge 0-2",
              {},
              {},
              {{0, 2}}},
        Fault{"face_turned",
              triangles({{0, 1, 2}, {0, 3, 2}}),
              Code::inconsistent_orientation,
              "recalculate the normals",
              {},
              {},
              {{0, 2}}},
        Fault{"closed",
              triangles({{0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {0, 4, 2}}),
              Code::closed_chart,
              "is closed: mark a seam that opens it, such as along edge",
              {0, 1, 2, 3}}),
    name_of);

FlattenError carried_by(const FlattenInput& input) {
  return flatten(input).pieces.at(0).error.value_or(FlattenError(Code::cancelled, "no error"));
}

TEST(ErrorCodes, SeamsAreProposedIfNothingElseHelps) {
  const FlattenError three_faces = carried_by(triangles({{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}));
  EXPECT_EQ(three_faces.elements.proposed_seams, three_faces.elements.edges);
  EXPECT_TRUE(carried_by(triangles({{0, 1, 2}, {0, 3, 2}})).elements.proposed_seams.empty()) << "flip a face";
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
  for (const double scale : {1e-57, 1e-30, 1e30, 0.9e60}) {
    const FlattenResult result = flatten(scaled(saddle, scale));
    ASSERT_FALSE(result.pieces[0].error.has_value()) << scale << " " << result.pieces[0].error->what();
    // Rounding errors change the last step, and each stage stops when the next step would gain less than 1e-9 of its
    // objective.
    EXPECT_LT((result.pieces[0].vertices / scale - expected).cwiseAbs().maxCoeff(), 1e-6) << scale;
  }
}

TEST(ErrorCodes, AnEdgeInTwoWires) {
  FlattenInput input = with_wire({0, 2});
  test::add_wire(input, {2, 0});
  const FlattenError error = test::error_of([&] { flatten(input); });
  EXPECT_EQ(error.code, Code::edge_in_two_wires);
  EXPECT_EQ(error.elements.edges, (std::vector<VertexPair>{{2, 0}}));
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
  for (const int bad : {-2, 0}) expect_refused([=](Options& o) { o.grain = bad; }, "grain");  // the input has no wires
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
  // A ring of quads without its last triangle. Its two ends touch only at one vertex.
  const int n = 8;
  FlattenInput input = test::flat_annulus(n, 1, 1, 2);
  const Eigen::RowVector3i left_out = input.faces.bottomRows(1);
  input.faces.conservativeResize(2 * n - 1, 3);
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::non_manifold_vertex);
  ASSERT_EQ(error.elements.vertices.size(), 1u);
  EXPECT_TRUE((left_out.array() == error.elements.vertices[0]).any());
  expect_words(error, "vertex " + std::to_string(error.elements.vertices[0]));
}

TEST(ErrorCodes, Handles) {
  FlattenInput torus = test::closed_torus(6, 6);
  torus.faces.conservativeResize(torus.faces.rows() - 1, 3);
  const FlattenError error = carried_by(torus);
  EXPECT_EQ(error.code, Code::handles);
  expect_words(error, "such as along edges");
}

TEST(ErrorCodes, OtherChartsAreFlattenedIfOneIsNotSolvable) {
  // A pyramid of squares, each 1e-10 times as large as the square below it. A random walk along the edges leaves the
  // inner squares with a probability below rounding errors, so the linear system is singular.
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> faces;
  const int rings = 4;
  for (int ring = 0; ring < rings; ++ring) {
    const double size = std::pow(1e-10, ring);
    points.insert(points.end(), {{size, 0, -size}, {0, size, -size}, {-size, 0, -size}, {0, -size, -size}});
    if (ring == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const int outer = 4 * (ring - 1) + i;
      const int next = 4 * (ring - 1) + (i + 1) % 4;
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
  ASSERT_TRUE(result.pieces[0].error.has_value());
  EXPECT_EQ(result.pieces[0].error->code, Code::not_solvable) << result.pieces[0].error->what();
  std::set<int> small;  // all faces without an edge on the outermost square
  for (std::size_t f = 0; f < num_nested; ++f) {
    if (f >= 8 || f % 2 == 1) small.insert(static_cast<int>(f));
  }
  const std::vector<int>& named = result.pieces[0].error->elements.faces;
  EXPECT_EQ(std::set<int>(named.begin(), named.end()), small);
  expect_words(*result.pieces[0].error, "differ too much in size");
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

// Flipping faces cannot give a one-sided surface one orientation.
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
  const FlattenError error = carried_by(strip);
  EXPECT_EQ(error.code, ErrorCode::inconsistent_orientation);
  expect_words(error, "one-sided");
  ASSERT_FALSE(error.elements.proposed_seams.empty());
  for (const VertexPair& pair : error.elements.proposed_seams) test::add_seam(strip, {pair[0], pair[1]});
  const FlattenResult result = flatten(strip);
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_FALSE(result.pieces[0].error) << result.pieces[0].error->what();
}

}  // namespace
}  // namespace wirewarp::test_error_codes
