// SPDX-License-Identifier: GPL-3.0-or-later
// Ways of cuts along edges.
#include <gtest/gtest.h>

#include <algorithm>

#include "cuts/propose/smooth_paths.h"
#include "test_meshes.h"

namespace wirewarp::test_smooth_paths {
namespace {

constexpr int kN = 14;  // edges a side
constexpr int kMiddle = 6;

bool is_inside(int i, int j) { return i > 0 && j > 0 && i < kN && j < kN; }

/// A way from the left and one from below, and all that is up and to the right of where they would meet.
bool is_open(int i, int j) {
  if (!is_inside(i, j)) return false;
  return (i >= kMiddle && j >= kMiddle) || (j == kMiddle && i < kMiddle) || (i == kMiddle && j < kMiddle);
}

/// At the crossing, and at the ends of both ways next to it, the edges of the grid alone.
bool is_diagonal_of_the_crossing(int i, int j, int other_i, int other_j) {
  const auto is_near = [](int a, int b) { return a + b <= 2 * kMiddle && a <= kMiddle && b <= kMiddle; };
  return i != other_i && j != other_j && (is_near(i, j) || is_near(other_i, other_j));
}

TEST(SmoothPaths, AWayThatWouldCrossItselfIsNone) {
  FlattenInput input = test::flat_rectangle(kN, kN, kN, kN);
  test::alternate_diagonals(input, kN);
  const Charts charts = test::charts_of(input);
  const Chart& chart = charts.charts[0];
  const auto column = [&](VertexHandle v) { return chart.source_vertex[v.idx()] % (kN + 1); };
  const auto row = [&](VertexHandle v) { return chart.source_vertex[v.idx()] / (kN + 1); };
  const auto at = [&](int i, int j) {
    const auto found = std::find(chart.source_vertex.begin(), chart.source_vertex.end(), i + (kN + 1) * j);
    return VertexHandle(static_cast<int>(found - chart.source_vertex.begin()));
  };
  Forbidden forbidden{std::vector<char>(chart.mesh.n_vertices(), 0), std::vector<char>(chart.mesh.n_edges(), 0)};
  for (const VertexHandle v : chart.mesh.vertices()) forbidden.vertices[v.idx()] = is_open(column(v), row(v)) ? 0 : 1;
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    const VertexHandle a = chart.mesh.from_vertex_handle(h), b = chart.mesh.to_vertex_handle(h);
    forbidden.edges[e.idx()] = is_diagonal_of_the_crossing(column(a), row(a), column(b), row(b)) ? 1 : 0;
  }
  const SmoothPathFinder finder(chart, forbidden);
  const SmoothPaths paths = finder.paths_from(at(1, kMiddle));
  EXPECT_TRUE(paths.arrival[at(kMiddle, 1).idx()].is_valid()) << "straight on, round a loop, and down the other way";
  EXPECT_TRUE(finder.path_to(paths, at(kMiddle, 1)).empty());
  EXPECT_EQ(finder.path_to(paths, at(kMiddle + 3, kMiddle)).size(), kMiddle + 2U);
}

}  // namespace
}  // namespace wirewarp::test_smooth_paths
