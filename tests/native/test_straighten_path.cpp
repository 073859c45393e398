// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of smooth lines beside paths of edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "error_of.h"
#include "test_meshes.h"
#include "wirewarp/straighten.h"

namespace wirewarp::test_straighten_path {
namespace {

constexpr int kN = 12;

int vertex(int i, int j) { return i + (kN + 1) * j; }

/// Returns a grid with edges of length 1 and diagonals in both directions.
FlattenInput grid() {
  FlattenInput input = test::flat_rectangle(kN, kN, kN, kN);
  test::alternate_diagonals(input, kN);
  return input;
}

/// Returns a path along the grid's edges, to the right and up, as near to the straight line as possible.
std::vector<int> stairs(int i, int j, int end_i, int end_j) {
  const int width = end_i - i, height = end_j - j;
  std::vector<int> path{vertex(i, j)};
  for (int right = 0, up = 0; right < width || up < height;) {
    (right < width && (2 * right + 1) * height <= (2 * up + 1) * width ? right : up) += 1;
    path.push_back(vertex(i + right, j + up));
  }
  return path;
}

Eigen::RowVector3d place(const FlattenInput& input, const LinePoint& point) {
  return (1 - point.t) * input.vertices.row(point.edge[0]) + point.t * input.vertices.row(point.edge[1]);
}

double length_of(const FlattenInput& input, const std::vector<LinePoint>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (place(input, line[i]) - place(input, line[i - 1])).norm();
  return length;
}

bool is_vertex(const LinePoint& point) { return point.edge[0] == point.edge[1]; }

bool passes(const std::vector<LinePoint>& line, int v) {
  return std::any_of(line.begin(), line.end(), [&](const LinePoint& p) { return is_vertex(p) && p.edge[0] == v; });
}

std::string message_of(const FlattenInput& input, const std::vector<int>& path) {
  return test::error_of([&] { straighten_path(input, path); }).what();
}

TEST(StraightenPath, BecomesTheLineBetweenItsEndsInAPlane) {
  const FlattenInput input = grid();
  for (const auto& [i, j] : {std::pair{11, 3}, {4, 11}, {10, 7}, {9, 9}}) {
    const std::vector<LinePoint> line = straighten_path(input, stairs(1, 2, i, j));
    const Eigen::RowVector3d start = input.vertices.row(vertex(1, 2));
    const Eigen::RowVector3d end = input.vertices.row(vertex(i, j));
    EXPECT_EQ(line.front().edge, (VertexPair{vertex(1, 2), vertex(1, 2)}));
    EXPECT_EQ(line.back().edge, (VertexPair{vertex(i, j), vertex(i, j)}));
    EXPECT_LT(length_of(input, line), 1.001 * (end - start).norm());
    for (const LinePoint& point : line) {
      const double aside = (place(input, point) - start).cross((end - start).normalized()).norm();
      EXPECT_LT(aside, 0.2) << "edge lengths, because the line snaps to nearby vertices";
    }
  }
}

TEST(StraightenPath, LeavesNoSliversAndTouchesEachTriangleOnce) {
  const FlattenInput input = grid();
  const std::vector<LinePoint> line = straighten_path(input, stairs(1, 1, 11, 8));
  ASSERT_GT(line.size(), 10U);
  std::vector<int> crossings(input.faces.rows(), 0);
  for (const LinePoint& point : line) {
    if (is_vertex(point)) {
      EXPECT_EQ(point.t, 0);
      continue;
    }
    EXPECT_GE(point.t, 0.05);
    EXPECT_LE(point.t, 0.95);
    for (int f = 0; f < input.faces.rows(); ++f) {
      const auto has = [&](int v) { return (input.faces.row(f).array() == v).any(); };
      if (has(point.edge[0]) && has(point.edge[1])) ++crossings[f];
    }
  }
  EXPECT_LE(*std::max_element(crossings.begin(), crossings.end()), 2) << "entering and leaving";
}

TEST(StraightenPath, IsAGeodesicOfACylinder) {
  const double angle = 2;
  const FlattenInput input = test::cylinder_patch(kN, kN, 1, angle, 2);
  const std::vector<LinePoint> line = straighten_path(input, stairs(1, 2, 11, 7));
  const double chord = 2 * std::sin(angle / kN / 2);  // because the mesh is a prism
  const double exact = std::hypot(10 * chord, 5 * 2.0 / kN);
  EXPECT_GT(length_of(input, line), exact * (1 - 1e-12));
  EXPECT_LT(length_of(input, line), exact * 1.002);
}

TEST(StraightenPath, TheReversedPathGivesTheSameLine) {
  FlattenInput input = grid();
  for (Eigen::Index v = 0; v < input.vertices.rows(); ++v) {  // so that no two paths are equally long
    const auto x = static_cast<double>(v);
    input.vertices.row(v) += 0.1 * Eigen::RowVector3d(std::sin(7 * x), std::cos(5 * x), std::sin(3 * x));
  }
  std::vector<int> path = stairs(1, 2, 11, 7);
  const std::vector<LinePoint> there = straighten_path(input, path);
  std::reverse(path.begin(), path.end());
  std::vector<LinePoint> back = straighten_path(input, path);
  std::reverse(back.begin(), back.end());
  ASSERT_EQ(there.size(), back.size());
  for (std::size_t i = 0; i < there.size(); ++i) {
    EXPECT_LT((place(input, there[i]) - place(input, back[i])).norm(), 1e-12) << i;
  }
}

TEST(StraightenPath, ABendStaysInPlace) {
  const FlattenInput input = grid();
  std::vector<int> path = stairs(2, 2, 2, 10);
  for (const int v : stairs(3, 10, 10, 10)) path.push_back(v);
  for (const LinePoint& point : straighten_path(input, path)) {
    const Eigen::RowVector3d at = place(input, point);
    EXPECT_LT(std::min(at[0] - 2, 10 - at[1]), 1 + 1e-9) << "beside one of its two legs";
  }
}

TEST(StraightenPath, MeetsWiresAtTheVerticesOfThePath) {
  const std::vector<int> path = stairs(1, 2, 11, 7);
  FlattenInput input = grid();
  const int i = path[6] % (kN + 1);
  test::add_wire(input, test::grid_column(kN, kN, i));
  const std::vector<LinePoint> line = straighten_path(input, path);
  EXPECT_TRUE(passes(line, path[6]) || passes(line, path[5]) || passes(line, path[7]));
  for (const LinePoint& point : line) {  // except at vertices of the path, the line stays off the wire
    const bool is_on_wire = std::abs(place(input, point)[0] - i) < 1e-9;
    const bool is_of_path = is_vertex(point) && std::find(path.begin(), path.end(), point.edge[0]) != path.end();
    EXPECT_TRUE(!is_on_wire || is_of_path);
  }
}

TEST(StraightenPath, GoesAroundASeam) {
  FlattenInput input = grid();
  const std::vector<int> slit = test::section(test::grid_column(kN, kN, 6), 0, 7);
  test::add_seam(input, slit);
  const std::vector<int> path{vertex(5, 6), vertex(5, 7), vertex(5, 8), vertex(6, 8),
                              vertex(7, 8), vertex(7, 7), vertex(7, 6)};
  const std::vector<LinePoint> line = straighten_path(input, path);
  EXPECT_GT(length_of(input, line), 2 * std::hypot(1, 1)) << "longer than through the end of the seam";
  EXPECT_LT(length_of(input, line), 5) << "shorter than the path, which is 6 long";
  for (const int v : slit) EXPECT_FALSE(passes(line, v));
}

TEST(StraightenPath, RefusesListsThatAreNotPaths) {
  FlattenInput input = grid();
  test::add_seam(input, test::grid_row(kN, 6));
  EXPECT_EQ(message_of(input, {5}), "The option path is too short: it must have two vertices or more.");
  EXPECT_EQ(message_of(input, {5, 999}),
            "The option path is through vertex 999: it must use the vertices of the mesh, 0 to 168.");
  EXPECT_EQ(message_of(input, {14, 17}),
            "The option path is through 14, 17: it must run along edges of the mesh, and these vertices have no edge.");
  EXPECT_EQ(message_of(input, {0, 1}),
            "The option path is through 0, 1: it must run inside a piece, and this edge is on a seam or an outline.");
  EXPECT_EQ(message_of(input, {vertex(3, 6), vertex(4, 6)}),
            "The option path is through 81, 82: it must run inside a piece, and this edge is on a seam or an outline.");
  EXPECT_EQ(message_of(input, {14, 15, 14}),
            "The option path is through vertex 14 twice: it must pass each vertex once, so straighten it in parts.");
}

TEST(StraightenPath, ReportsTheErrorOfThePiece) {
  FlattenInput input = grid();
  input.faces.conservativeResize(input.faces.rows() + 1, 3);
  input.faces.bottomRows(1) = input.faces.row(30);
  const int a = input.faces(30, 0), b = input.faces(30, 1);
  EXPECT_EQ(message_of(input, {a, b}), "Face 288 has the vertices of another face: delete the copies.");
}

}  // namespace
}  // namespace wirewarp::test_straighten_path
