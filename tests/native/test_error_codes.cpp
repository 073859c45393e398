// SPDX-License-Identifier: GPL-3.0-or-later
// Every code of error.h fired, with the offending elements named in the lists and in the sentence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/planar.h"
#include "newton/solve/chart_errors.h"
#include "test_meshes.h"

namespace wirewarp::test_error_codes {
namespace {

using Code = ErrorCode;

FlattenInput triangles(const std::vector<std::array<double, 3>>& points, const std::vector<std::array<int, 3>>& faces) {
  FlattenInput input;
  input.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  input.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    input.vertices.row(static_cast<Eigen::Index>(i)) << points[i][0], points[i][1], points[i][2];
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    input.faces.row(static_cast<Eigen::Index>(i)) << faces[i][0], faces[i][1], faces[i][2];
  }
  return input;
}

const std::vector<std::array<double, 3>> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};

FlattenError thrown_by(const FlattenInput& input, const Options& options = {}) {
  try {
    flatten(input, options);
  } catch (const FlattenError& error) {
    return error;
  }
  return FlattenError(Code::cancelled, "nothing was thrown");
}

FlattenError carried_by(const FlattenInput& input, std::size_t piece = 0) {
  const FlattenResult result = flatten(input);
  EXPECT_TRUE(result.pieces[piece].error.has_value());
  return result.pieces[piece].error.value_or(FlattenError(Code::cancelled, "no error"));
}

void expect_names(const FlattenError& error, const std::string& words) {
  EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
}

TEST(ErrorCodes, EmptyMesh) { EXPECT_EQ(thrown_by(FlattenInput{}).code, Code::empty_mesh); }

/// Each on vertices of its own.
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

TEST(ErrorCodes, LooseFacesAreThousandsOfPartsOfAFaceEach) {
  const FlattenError triangles = thrown_by(loose_squares(1001, 1));
  EXPECT_EQ(triangles.code, Code::loose_faces);
  expect_names(triangles,
               "The 1001 triangles of the mesh are 1001 separate parts, such as faces 0, 1, 2, 3, 4 and 996 "
               "more: merge vertices by distance");
  EXPECT_EQ(triangles.elements.faces.size(), 1001U);
  const FlattenError squares = thrown_by(loose_squares(1001, 2));
  EXPECT_EQ(squares.code, Code::loose_faces);
  expect_names(squares, "The 2002 triangles of the mesh are 1001 separate parts");
  const FlattenResult allowed = flatten(loose_squares(1000, 1));
  EXPECT_EQ(allowed.pieces.size(), 1000U);
  EXPECT_FALSE(allowed.pieces.front().error);
}

TEST(ErrorCodes, VertexOutOfRangeInFacesSeamsAndWires) {
  const FlattenError face = thrown_by(triangles(kSquare, {{0, 1, 2}, {0, 2, 7}}));
  EXPECT_EQ(face.code, Code::vertex_out_of_range);
  EXPECT_EQ(face.elements.faces, std::vector<int>{1});
  EXPECT_EQ(face.elements.vertices, std::vector<int>{7});
  expect_names(face, "Face 1 names vertex 7,");
  const FlattenError faces = thrown_by(triangles(kSquare, {{0, 7, 2}, {0, 9, 7}}));
  EXPECT_EQ(faces.elements.vertices, (std::vector<int>{7, 9}));
  expect_names(faces, "Faces 0 and 1 name vertices 7 and 9,");

  FlattenInput seam = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_seam(seam, {0, 99});
  EXPECT_EQ(thrown_by(seam).code, Code::vertex_out_of_range);
  FlattenInput wire = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_wire(wire, {0, -1});
  EXPECT_EQ(thrown_by(wire).code, Code::vertex_out_of_range);
}

TEST(ErrorCodes, NonFiniteAndOverflowingCoordinates) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e60, -1e200}) {
    FlattenInput input = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
    input.vertices(2, 1) = bad;
    const FlattenError error = thrown_by(input);
    EXPECT_EQ(error.code, Code::non_finite_coordinates);
    EXPECT_EQ(error.elements.vertices, std::vector<int>{2});
    expect_names(error, "vertex 2");
  }
}

TEST(ErrorCodes, SizesBetweenTheLimitsAreFlattenedAlike) {
  FlattenInput saddle = test::saddle(6, 0.4);  // nothing here buckles, to this or that side by rounding
  test::add_wire(saddle, test::grid_row(6, 2));
  const Positions2 expected = flatten(saddle).pieces[0].vertices;
  for (const double scale : {1e-57, 1e-30, 1e30, 0.9e60}) {
    FlattenInput input = saddle;
    input.vertices *= scale;
    const FlattenResult result = flatten(input);
    ASSERT_FALSE(result.pieces[0].error.has_value()) << scale << " " << result.pieces[0].error->what();
    // Rounding leads to another last step, and each stops where a step promises less than 1e-9 of what it minimizes.
    EXPECT_LT((result.pieces[0].vertices / scale - expected).cwiseAbs().maxCoeff(), 1e-6) << scale;
  }
}

TEST(ErrorCodes, ATriangleTooSmallForItsAreaIsAPoint) {
  FlattenInput input = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  input.vertices *= 1e-61;
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::zero_area_face);
  EXPECT_EQ(error.elements.faces, (std::vector<int>{0, 1}));
}

TEST(ErrorCodes, SeamAndWireThatAreNoEdges) {
  FlattenInput seam = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_seam(seam, {1, 3});
  const FlattenError seam_error = thrown_by(seam);
  EXPECT_EQ(seam_error.code, Code::seam_not_an_edge);
  EXPECT_EQ(seam_error.elements.edges, (std::vector<VertexPair>{{1, 3}}));
  expect_names(seam_error, "edge 1-3");

  FlattenInput wire = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_wire(wire, {0, 1, 3}, 0, "bust");
  const FlattenError wire_error = thrown_by(wire);
  EXPECT_EQ(wire_error.code, Code::wire_not_an_edge);
  EXPECT_EQ(wire_error.elements.edges, (std::vector<VertexPair>{{1, 3}}));
  expect_names(wire_error, "wire 0 (bust)");
}

TEST(ErrorCodes, WireTooShort) {
  FlattenInput input = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_wire(input, {2});
  EXPECT_EQ(thrown_by(input).code, Code::wire_too_short);
}

TEST(ErrorCodes, EdgeInTwoWiresOrTwiceInOne) {
  FlattenInput two = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_wire(two, {0, 2});
  test::add_wire(two, {2, 0});
  const FlattenError error = thrown_by(two);
  EXPECT_EQ(error.code, Code::edge_in_two_wires);
  EXPECT_EQ(error.elements.edges, (std::vector<VertexPair>{{2, 0}}));
  FlattenInput twice = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_wire(twice, {0, 2, 0});
  EXPECT_EQ(thrown_by(twice).code, Code::edge_in_two_wires);
}

TEST(ErrorCodes, InvalidTolerance) {
  for (const double bad : {-0.01, std::nan("")}) {
    FlattenInput input = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
    test::add_wire(input, {0, 2}, bad);
    EXPECT_EQ(thrown_by(input).code, Code::invalid_tolerance);
  }
}

TEST(ErrorCodes, InvalidOption) {
  const FlattenInput input = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  for (const double bad : {-0.1, 1.5, std::nan("")}) {
    Options options;
    options.gap = bad;
    EXPECT_EQ(thrown_by(input, options).code, Code::invalid_option);
  }
  for (const int bad : {-2, 0}) {  // the input has no wires
    Options options;
    options.grain = bad;
    EXPECT_EQ(thrown_by(input, options).code, Code::invalid_option);
  }
  for (const std::array<double, 3>& bad : {std::array<double, 3>{0, 0, 0}, {0, std::nan(""), 1}}) {
    Options options;
    options.up = bad;
    EXPECT_EQ(thrown_by(input, options).code, Code::invalid_option);
  }
  for (const double bad : {0.0, 0.0009, 11.0, -0.1, std::nan("")}) {
    Options options;
    options.fairness = bad;
    EXPECT_EQ(thrown_by(input, options).code, Code::invalid_option);
    expect_names(thrown_by(input, options), "between 0.001 and 10");
  }
  for (const int bad : {0, -3}) {
    Options options;
    options.max_factorizations = bad;
    EXPECT_EQ(thrown_by(input, options).code, Code::invalid_option);
    expect_names(thrown_by(input, options), "max_factorizations is " + std::to_string(bad));
  }
}

TEST(ErrorCodes, OptionsAndWiresAreCheckedWithoutAMeshToo) {
  Options options;
  options.grain = 5;  // there may be as many wires
  EXPECT_NO_THROW(check_options(options));
  options.grain = -2;
  EXPECT_THROW(check_options(options), FlattenError);
  EXPECT_NO_THROW(check_wire({{7, 9}, 0.1, "waist"}));
  try {
    check_wire({{7}, 0.1, "waist"});
    FAIL();
  } catch (const FlattenError& error) {
    EXPECT_EQ(error.code, Code::wire_too_short);
    EXPECT_TRUE(error.elements.vertices.empty()) << "of what mesh?";
    expect_names(error, "wire (waist)");
  }
  EXPECT_THROW(check_wire({{7, 9}, -1, ""}), FlattenError);
}

TEST(ErrorCodes, CornersOfTheWrongNumberOfFaces) {
  const FlattenInput input = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  try {
    measure(input, CornerUv::Zero(5, 6));
    FAIL();
  } catch (const FlattenError& error) {
    EXPECT_EQ(error.code, Code::invalid_shape);
  }
}

TEST(ErrorCodes, FaultyFaces) {
  const FlattenError repeated_vertex = carried_by(triangles(kSquare, {{0, 1, 2}, {0, 2, 2}}));
  EXPECT_EQ(repeated_vertex.code, Code::repeated_vertex_in_face);
  EXPECT_EQ(repeated_vertex.elements.faces, std::vector<int>{1});
  expect_names(repeated_vertex, "Face 1");

  const FlattenError repeated = carried_by(triangles(kSquare, {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}));
  EXPECT_EQ(repeated.code, Code::repeated_face);
  EXPECT_EQ(repeated.elements.faces, std::vector<int>{2});

  const FlattenError flat = carried_by(triangles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(flat.code, Code::zero_area_face);
  EXPECT_EQ(flat.elements.faces, std::vector<int>{0});
}

TEST(ErrorCodes, ASliverOfAMillionthRadianIsLegal) {
  const FlattenResult result = flatten(triangles({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-6, 0}}, {{0, 1, 2}}));
  EXPECT_FALSE(result.pieces[0].error.has_value()) << result.pieces[0].error->what();
}

TEST(ErrorCodes, NonManifoldEdge) {
  const FlattenError error = carried_by(triangles(kSquare, {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}));
  EXPECT_EQ(error.code, Code::non_manifold_edge);
  EXPECT_EQ(error.elements.edges, (std::vector<VertexPair>{{0, 2}}));
  expect_names(error, "edge 0-2");
  EXPECT_EQ(error.elements.proposed_seams, error.elements.edges);
}

TEST(ErrorCodes, NonManifoldVertex) {
  // A ring of quads but for one triangle: its ends touch in a vertex.
  const int n = 8;
  FlattenInput input = test::flat_annulus(n, 1, 1, 2);
  const Eigen::RowVector3i left_out = input.faces.bottomRows(1);
  input.faces.conservativeResize(2 * n - 1, 3);
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::non_manifold_vertex);
  ASSERT_EQ(error.elements.vertices.size(), 1u);
  EXPECT_TRUE((left_out.array() == error.elements.vertices[0]).any());
  expect_names(error, "vertex " + std::to_string(error.elements.vertices[0]));
}

TEST(ErrorCodes, InconsistentOrientation) {
  const FlattenError error = carried_by(triangles(kSquare, {{0, 1, 2}, {0, 3, 2}}));
  EXPECT_EQ(error.code, Code::inconsistent_orientation);
  EXPECT_EQ(error.elements.edges, (std::vector<VertexPair>{{0, 2}}));
  expect_names(error, "recalculate the normals");
  EXPECT_TRUE(error.elements.proposed_seams.empty());  // turning a face is enough
}

TEST(ErrorCodes, ClosedChart) {
  const FlattenError error =
      carried_by(triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}));
  EXPECT_EQ(error.code, Code::closed_chart);
  EXPECT_EQ(error.elements.faces.size(), 4u);
  const VertexPair& seam = error.elements.proposed_seams.at(0);
  expect_names(error, "is closed: mark a seam that opens it, such as along edge");
  expect_names(error, std::to_string(seam[0]) + "-" + std::to_string(seam[1]));
}

TEST(ErrorCodes, Handles) {
  // A torus of 6 by 6 quads with one face left out.
  FlattenInput input;
  const int n = 6;
  const auto vertex = [&](int i, int j) { return (i % n) + n * (j % n); };
  input.vertices.resize(n * n, 3);
  input.faces.resize(2 * n * n - 1, 3);
  int f = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double a = 2 * kPi * i / n;
      const double b = 2 * kPi * j / n;
      input.vertices.row(vertex(i, j)) << (2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b);
      input.faces.row(f++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
      if (f < input.faces.rows()) input.faces.row(f++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
    }
  }
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::handles);
  expect_names(error, "such as along edges");
}

TEST(ErrorCodes, InfeasibleLengths) {
  // A cap of five triangles round an apex, every edge a rigid wire: the angles at the apex are given, and too small.
  std::vector<std::array<double, 3>> points{{0, 0, 1}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 5; ++i) {
    points.push_back({std::cos(2 * kPi * i / 5), std::sin(2 * kPi * i / 5), 0});
    faces.push_back({0, 1 + i, 1 + (i + 1) % 5});
  }
  FlattenInput input = triangles(points, faces);
  for (int i = 0; i < 5; ++i) test::add_wire(input, {0, 1 + i});
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::infeasible_lengths);
  EXPECT_EQ(error.elements.faces.size(), 5u);
  // Two wires are enough: which two, rounding decides.
  EXPECT_GE(error.elements.edges.size(), 2u);
  for (const ProposedTolerance& proposed : error.elements.proposed_tolerances) {
    input.wires.at(proposed.wire).tolerance = proposed.tolerance;
  }
  EXPECT_FALSE(flatten(input).pieces.at(0).error);
}

TEST(ErrorCodes, AChartThatIsNotSolvableSparesTheOthers) {
  // A pyramid of squares, each a ten-billionth of the one below it: a walk along the edges leaves the inner ones so
  // rarely that the chance drowns in rounding.
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

  const FlattenResult result = flatten(triangles(points, faces));
  ASSERT_TRUE(result.pieces[0].error.has_value());
  EXPECT_EQ(result.pieces[0].error->code, Code::not_solvable) << result.pieces[0].error->what();
  std::set<int> small;  // all but those with a side of the outermost square
  for (std::size_t f = 0; f < num_nested; ++f) {
    if (f >= 8 || f % 2 == 1) small.insert(static_cast<int>(f));
  }
  const std::vector<int>& named = result.pieces[0].error->elements.faces;
  EXPECT_EQ(std::set<int>(named.begin(), named.end()), small);
  expect_names(*result.pieces[0].error, "differ too much in size");
  EXPECT_EQ(result.pieces[0].report.termination, Termination::failed);
  EXPECT_FALSE(result.pieces[1].error.has_value());
}

TEST(ErrorCodes, WiresThatCannotBeJoinedNameThemselvesAndTheRefinedMethod) {
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
  expect_names(error, "use the refined method");
}

TEST(ErrorCodes, EveryCodeHasItsDescription) {
  for (const ErrorCode code : all_error_codes()) {
    EXPECT_FALSE(std::string(describe(code).name).empty());
    EXPECT_FALSE(std::string(describe(code).meaning).empty());
    EXPECT_FALSE(std::string(describe(code).remedy).empty());
  }
}

}  // namespace
}  // namespace wirewarp::test_error_codes
