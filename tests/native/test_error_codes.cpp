// SPDX-License-Identifier: GPL-3.0-or-later
// Every code of error.h fired, with the offending elements named in the lists and in the sentence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "test_meshes.h"

namespace wirewarp {
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

TEST(ErrorCodes, VertexOutOfRangeInFacesSeamsAndWires) {
  const FlattenError face = thrown_by(triangles(kSquare, {{0, 1, 2}, {0, 2, 7}}));
  EXPECT_EQ(face.code, Code::vertex_out_of_range);
  EXPECT_EQ(face.elements.faces, std::vector<int>{1});
  EXPECT_EQ(face.elements.vertices, std::vector<int>{7});
  expect_names(face, "face 1");

  FlattenInput seam = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_seam(seam, {0, 99});
  EXPECT_EQ(thrown_by(seam).code, Code::vertex_out_of_range);
  FlattenInput wire = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
  test::add_wire(wire, {0, -1});
  EXPECT_EQ(thrown_by(wire).code, Code::vertex_out_of_range);
}

TEST(ErrorCodes, NonFiniteAndOverflowingCoordinates) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    FlattenInput input = triangles(kSquare, {{0, 1, 2}, {0, 2, 3}});
    input.vertices(2, 1) = bad;
    const FlattenError error = thrown_by(input);
    EXPECT_EQ(error.code, Code::non_finite_coordinates);
    EXPECT_EQ(error.elements.vertices, std::vector<int>{2});
    expect_names(error, "vertex 2");
  }
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
  expect_names(repeated_vertex, "face 1");

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
}

TEST(ErrorCodes, NonManifoldVertex) {
  // Two triangles that touch in vertex 0.
  const FlattenInput input =
      triangles({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  for (std::size_t piece : {0u, 1u}) {
    const FlattenError error = carried_by(input, piece);
    EXPECT_EQ(error.code, Code::non_manifold_vertex);
    EXPECT_EQ(error.elements.vertices, std::vector<int>{0});
    expect_names(error, "vertex 0");
  }
}

TEST(ErrorCodes, InconsistentOrientation) {
  const FlattenError error = carried_by(triangles(kSquare, {{0, 1, 2}, {0, 3, 2}}));
  EXPECT_EQ(error.code, Code::inconsistent_orientation);
  EXPECT_EQ(error.elements.edges, (std::vector<VertexPair>{{0, 2}}));
}

TEST(ErrorCodes, ClosedChart) {
  const FlattenError error =
      carried_by(triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}));
  EXPECT_EQ(error.code, Code::closed_chart);
  EXPECT_EQ(error.elements.faces.size(), 4u);
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
      const double a = 2 * 3.141592653589793 * i / n;
      const double b = 2 * 3.141592653589793 * j / n;
      input.vertices.row(vertex(i, j)) << (2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b);
      input.faces.row(f++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
      if (f < input.faces.rows()) input.faces.row(f++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
    }
  }
  EXPECT_EQ(carried_by(input).code, Code::handles);
}

TEST(ErrorCodes, HingedWireThatEndsInside) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  std::vector<int> half = test::grid_row(n, 3);
  half.resize(4);
  test::add_wire(input, test::grid_column(n, n, 5));
  test::add_wire(input, half, 0, "dangling");
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::hinged_wire);
  EXPECT_EQ(error.elements.vertices, std::vector<int>{half.back()});
  EXPECT_EQ(error.elements.edges.size(), 3u);
  expect_names(error, "Wire 1 (dangling)");
}

TEST(ErrorCodes, ASingleWireBetweenTwoLoopsIsHinged) {
  FlattenInput input = test::flat_annulus(12, 3, 1, 2);
  const int inner = test::nearest_vertex(input, {1, 0, 0});
  const int outer = test::nearest_vertex(input, {2, 0, 0});
  const int first = test::nearest_vertex(input, {4.0 / 3, 0, 0});
  const int second = test::nearest_vertex(input, {5.0 / 3, 0, 0});
  test::add_wire(input, {inner, first, second, outer});
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::hinged_wire);
  EXPECT_EQ(std::set<int>(error.elements.vertices.begin(), error.elements.vertices.end()),
            std::set<int>({inner, outer}));
}

TEST(ErrorCodes, SeparateLoops) {
  const FlattenError hole = carried_by(test::flat_annulus(12, 3, 1, 2));
  EXPECT_EQ(hole.code, Code::separate_loops);
  EXPECT_EQ(hole.elements.vertices.size(), 24u);

  const int n = 6;
  FlattenInput ring = test::flat_rectangle(n, n, 1, 1);
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  test::add_wire(ring, {vertex(2, 2), vertex(4, 2), vertex(4, 4), vertex(2, 4), vertex(2, 2)});
  ring.wires[0].vertices = {vertex(2, 2), vertex(3, 2), vertex(4, 2), vertex(4, 3), vertex(4, 4),
                            vertex(3, 4), vertex(2, 4), vertex(2, 3), vertex(2, 2)};
  const FlattenError error = carried_by(ring);
  EXPECT_EQ(error.code, Code::separate_loops);
  expect_names(error, "Wire 0");
}

TEST(ErrorCodes, InfeasibleLengths) {
  // A cap of five triangles round an apex, every edge a rigid wire: the angles at the apex are given, and too small.
  std::vector<std::array<double, 3>> points{{0, 0, 1}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * 3.141592653589793 * i / 5;
    points.push_back({std::cos(a), std::sin(a), 0});
    faces.push_back({0, 1 + i, 1 + (i + 1) % 5});
  }
  FlattenInput input = triangles(points, faces);
  for (int i = 0; i < 5; ++i) test::add_wire(input, {0, 1 + i});
  const FlattenError error = carried_by(input);
  EXPECT_EQ(error.code, Code::infeasible_lengths);
  EXPECT_EQ(error.elements.faces.size(), 5u);
}

TEST(ErrorCodes, ABadChartSparesTheOthers) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, test::grid_column(n, n, 3));
  const int doubled = 0;
  input.faces.conservativeResize(input.faces.rows() + 1, 3);
  input.faces.row(input.faces.rows() - 1) = input.faces.row(doubled);
  const FlattenResult result = flatten(input);
  ASSERT_EQ(result.pieces.size(), 2u);
  ASSERT_TRUE(result.pieces[0].error.has_value());
  EXPECT_FALSE(result.pieces[0].error->has_layout);
  EXPECT_TRUE(result.pieces[0].vertices.array().isNaN().all());
  EXPECT_FALSE(result.pieces[1].error.has_value());
  for (int f = 0; f < input.faces.rows(); ++f) {
    const auto& good = result.pieces[1].source_face;
    const bool is_good = std::find(good.begin(), good.end(), f) != good.end();
    EXPECT_EQ(result.corner_uv.row(f).allFinite(), is_good);
  }
  ASSERT_EQ(result.seams.size(), 1u);
  EXPECT_EQ(result.seams[0].pieces, (std::vector<int>{0, 1}));
}

TEST(ErrorCodes, Cancelled) {
  const FlattenResult result = flatten(test::quarter_sphere(4), {}, [](const std::string&, double) { return false; });
  ASSERT_TRUE(result.pieces[0].error.has_value());
  EXPECT_EQ(result.pieces[0].error->code, Code::cancelled);
  EXPECT_EQ(result.pieces[0].report.termination, Termination::cancelled);
}

TEST(ErrorCodes, MeasuredFlatteningWithGapsAndCuts) {
  const FlattenInput input = test::flat_rectangle(2, 2, 1, 1);
  CornerUv corners = flatten(input).corner_uv;
  CornerUv torn = corners;
  torn(0, 0) += 0.5;
  const FlattenResult cut = measure(input, torn);
  ASSERT_TRUE(cut.pieces[0].error.has_value());
  EXPECT_EQ(cut.pieces[0].error->code, Code::uv_discontinuous);
  EXPECT_FALSE(cut.pieces[0].error->elements.vertices.empty());

  corners(3, 2) = std::nan("");
  const FlattenResult missing = measure(input, corners);
  ASSERT_TRUE(missing.pieces[0].error.has_value());
  EXPECT_EQ(missing.pieces[0].error->code, Code::no_layout);
  EXPECT_EQ(missing.pieces[0].error->elements.faces, std::vector<int>{3});
}

TEST(ErrorCodes, EveryCodeHasItsDescription) {
  for (const ErrorCode code : all_error_codes()) {
    EXPECT_FALSE(std::string(describe(code).name).empty());
    EXPECT_FALSE(std::string(describe(code).meaning).empty());
    EXPECT_FALSE(std::string(describe(code).remedy).empty());
  }
}

}  // namespace
}  // namespace wirewarp
