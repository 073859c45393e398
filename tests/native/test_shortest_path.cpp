// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/planar.h"
#include "test_meshes.h"
#include "warp/topology/shortest_path.h"

namespace wirewarp::test_shortest_path {
namespace {

/// Length of the straightened shortest path between two vertices.
double geodesic_length(const Chart& chart, int from, int to) {
  const WireMask wires(chart);
  std::vector<char> is_target(chart.mesh.n_vertices(), 0);
  is_target[to] = 1;
  const auto edge_path = shortest_edge_path(chart.mesh, wires, {VertexHandle(from)}, is_target);
  EXPECT_FALSE(edge_path.empty());
  const MeshPath path = straighten(chart.mesh, wires, edge_path);
  EXPECT_EQ(path.front().vertex, VertexHandle(from));
  EXPECT_EQ(path.back().vertex, VertexHandle(to));
  return path_length(chart.mesh, path);
}

TEST(ShortestPath, IsTheLineBetweenTwoVerticesOfAPlane) {
  const int n = 20;
  const Charts charts = test::charts_of(test::flat_rectangle(n, n, n, n));
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  for (const auto& [i, j] : {std::pair{17, 3}, {3, 17}, {10, 18}, {18, 9}, {2, 3}, {18, 18}}) {
    EXPECT_NEAR(geodesic_length(charts.charts[0], vertex(2, 2), vertex(i, j)), std::hypot(i - 2, j - 2), 1e-12);
  }
}

TEST(ShortestPath, IsExactOnACylinder) {
  const int n = 40;
  const double angle = 3;
  const Charts charts = test::charts_of(test::cylinder_patch(n, n, 1, angle, 2));
  const double chord = 2 * std::sin(angle / n / 2);  // the mesh is a prism
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  for (const auto& [i, j] : {std::pair{37, 5}, {5, 37}, {30, 30}, {12, 36}}) {
    const double exact = std::hypot(chord * (i - 3), 2.0 / n * (j - 4));
    EXPECT_NEAR(geodesic_length(charts.charts[0], vertex(3, 4), vertex(i, j)), exact, 1e-10);
  }
}

TEST(ShortestPath, IsExactOnACone) {
  const int n = 40;
  const double angle = 2;
  const Charts charts = test::charts_of(test::cone_patch(n, n, 1, 4, 0.5, angle));
  const double sector = 2 * std::asin(std::sin(0.5) * std::sin(angle / n / 2));  // the mesh is a pyramid
  const auto unrolled = [&](int i, int j) { return std::polar(4 - 3.0 * j / n, sector * i); };
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  for (const auto& [i, j] : {std::pair{35, 5}, {5, 37}, {30, 30}, {12, 36}}) {
    const double exact = std::abs(unrolled(i, j) - unrolled(3, 6));
    EXPECT_NEAR(geodesic_length(charts.charts[0], vertex(3, 6), vertex(i, j)), exact, 1e-10);
  }
}

TEST(ShortestPath, TendsToAGreatCircleOnTheSphere) {
  double previous_error = 1;
  for (const int n : {8, 16, 32, 64}) {
    Charts charts = test::charts_of(test::quarter_sphere(n));
    charts.charts[0].wire_parts.clear();
    const int from = n / 4 + (n + 1) * (n / 4);
    const int to = n * 7 / 8 + (n + 1) * (n * 3 / 2);
    const auto p = charts.charts[0].mesh.point(VertexHandle(from));
    const auto q = charts.charts[0].mesh.point(VertexHandle(to));
    const double error = std::abs(geodesic_length(charts.charts[0], from, to) - std::acos(p | q));
    EXPECT_LT(error, previous_error / 3) << n;  // second order
    previous_error = error;
  }
  EXPECT_LT(previous_error, 1e-3);
}

TEST(ShortestPath, GoesTheShortWayRoundATube) {
  const int nx = 24;
  const Charts charts = test::charts_of(test::cylinder_tube(nx, 10, 1, 2));
  const double chord = 2 * std::sin(kPi / nx);
  EXPECT_NEAR(geodesic_length(charts.charts[0], nx * 3 + 1, nx * 7 + 22), std::hypot(3 * chord, 0.8), 1e-12);
}

TEST(ShortestPath, StaysAQuarterOfAnEdgeAwayFromWires) {
  // Around the end of a slit that stands between the two vertices.
  const int n = 8;
  FlattenInput input = test::flat_rectangle(n, n, n, n);
  std::vector<int> slit = test::grid_column(n, n, 4);
  slit.resize(6);
  test::add_seam(input, slit);
  const Charts charts = test::charts_of(input);
  const Chart& chart = charts.charts[0];
  const auto find = [&](int i, int j) {
    return static_cast<int>(std::find(chart.source_vertex.begin(), chart.source_vertex.end(), i + (n + 1) * j) -
                            chart.source_vertex.begin());
  };
  const double length = geodesic_length(chart, find(1, 2), find(7, 2));
  EXPECT_GT(length, 2 * std::hypot(3, 3)) << "longer than touching the slit's end";
  EXPECT_LT(length, 2 * std::hypot(3, 3.5)) << "not as long as through the next vertices";
}

TEST(ShortestPath, TakesTheNearestOfManySourcesAndTargets) {
  const int n = 10;
  const Charts charts = test::charts_of(test::flat_rectangle(n, n, 1, 1));
  const auto vertex = [&](int i, int j) { return VertexHandle(i + (n + 1) * j); };
  std::vector<char> is_target(charts.charts[0].mesh.n_vertices(), 0);
  is_target[vertex(2, 8).idx()] = 1;
  is_target[vertex(8, 5).idx()] = 1;
  const auto path = shortest_edge_path(charts.charts[0].mesh, WireMask(charts.charts[0]),
                                       {vertex(1, 1), vertex(6, 5), vertex(3, 3)}, is_target);
  EXPECT_EQ(path, (std::vector<VertexHandle>{vertex(6, 5), vertex(7, 5), vertex(8, 5)}));
}

TEST(ShortestPath, SaysWhereThereIsNone) {
  const Charts charts = test::charts_of(test::flat_rectangle(4, 4, 1, 1));
  SplitChart refined(charts.charts[0]);
  const std::vector<char> no_target(charts.charts[0].mesh.n_vertices(), 0);
  EXPECT_THROW(join_by_shortest_path(refined, {VertexHandle(12)}, no_target), std::domain_error);
}

}  // namespace
}  // namespace wirewarp::test_shortest_path
