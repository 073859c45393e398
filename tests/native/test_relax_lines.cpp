// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of lines that become shorter on the surface, and of the straight walk that moves their points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "base/planar.h"
#include "cuts/feasibility/cut_mask.h"
#include "cuts/propose/relax_lines.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/topology/straight_walk.h"

namespace wirewarp::test_relax_lines {
namespace {

TEST(LineNetwork, DoesNotFollowBarriers) {
  const int n = 12;
  const Chart chart = test::chart_of(test::flat_rectangle(n, n, n, n));
  const auto at = [](int x, int y) { return VertexHandle(y * (n + 1) + x); };
  std::vector<VertexHandle> arch;  // a line over the barrier
  for (int x = 0; x < 3; ++x) arch.push_back(at(x, 6));
  for (int y = 6; y < 9; ++y) arch.push_back(at(3, y));
  for (int x = 3; x < 9; ++x) arch.push_back(at(x, 9));
  for (int y = 9; y > 6; --y) arch.push_back(at(9, y));
  for (int x = 9; x <= n; ++x) arch.push_back(at(x, 6));
  HalfEdgeChain chain;
  for (std::size_t i = 1; i < arch.size(); ++i) chain.push_back(chart.mesh.find_halfedge(arch[i - 1], arch[i]));
  CutMask barriers(chart.mesh.n_edges(), 0);
  for (int x = 4; x < 8; ++x)
    barriers[static_cast<std::size_t>(chart.mesh.find_halfedge(at(x, 8), at(x + 1, 8)).idx() / 2)] = 1;
  const LineNetwork network(chart.mesh, lines_along(chart, {}, cut_along(chart.mesh, chain)).lines, barriers);
  EXPECT_TRUE(network.relax({network.steps_for(1)}, StopToken()).front().has_value());
  // After so many steps, the line is too close to the barrier.
  EXPECT_FALSE(network.relax({network.steps_for(8)}, StopToken()).front().has_value());
}

TEST(LineNetwork, MovesAJunctionToAnEdgeOnlyIfItsLinesMove) {
  const Chart chart = test::chart_of(test::flat_rectangle(6, 6, 6, 6));
  const HalfedgeHandle first = chart.mesh.halfedge_handle(FaceHandle(20));
  const FaceHandle face = chart.mesh.face_handle(first);
  const Planar a(0), b(edge_length(chart.mesh, first)), junction = 0.54 * b + 0.04 * apex_over(chart.mesh, first);
  std::vector<SurfaceLine> lines(2);
  lines[0] = {0, 1, {{face, junction, a, VertexHandle(), chart.mesh.from_vertex_handle(first), EdgeHandle()}}};
  lines[1] = {0, 2, {{face, junction, b, VertexHandle(), chart.mesh.to_vertex_handle(first), EdgeHandle()}}};
  const CutMask no_barriers(chart.mesh.n_edges(), 0);
  const LineNetwork network(chart.mesh, lines, no_barriers);
  const auto junction_after = [&](const std::vector<int>& steps) {
    return network.relax(steps, StopToken()).front()->start.place;
  };
  EXPECT_EQ(junction_after({1, 0}), junction);
  EXPECT_EQ(junction_after({1, 1}).imag(), 0);
}

/// Returns a bumpy sheet of 6 by 6 with 12 by 12 quads.
FlattenInput bumpy_sheet() {
  return test::make_grid(12, 12, [](double s, double t) {
    return Eigen::Vector3d(6 * s, 6 * t, 0.5 * std::sin(6 * s) * std::cos(5 * t));
  });
}

TEST(StraightWalk, GoesBackAlongTheLineToTheEndOfAStep) {
  const Chart chart = test::chart_of(bumpy_sheet());
  const CutMask no_barriers(chart.mesh.n_edges(), 0);
  const StraightWalk walk(chart.mesh, no_barriers);
  const SurfacePoint start = point_on_edge(chart.mesh, chart.mesh.halfedge_handle(chart.mesh.face_handle(100)), 0.3);
  for (int k = 0; k < 12; ++k) {
    const Planar step = std::polar(0.4, 2 * kPi * k / 12);
    const auto line = walk.line(start, walk.step(start, step), 1);
    ASSERT_TRUE(line.has_value());
    EXPECT_NEAR(std::abs(line->leaving), std::abs(line->returning), 1e-9);
    EXPECT_LE(std::abs(line->leaving), 0.4 + 1e-9);
  }
}

TEST(StraightWalk, PassesAVertexThatHidesTheEnd) {
  // There are more than 360 degrees around the middle vertex of this sheet, so opposite points do not see each other.
  const FlattenInput sheet = test::saddle(2, 3);
  const Chart chart = test::chart_of(sheet);
  const CutMask no_barriers(chart.mesh.n_edges(), 0);
  const StraightWalk walk(chart.mesh, no_barriers);
  const VertexHandle middle(4);
  std::vector<HalfedgeHandle> around;
  for (const HalfedgeHandle h : chart.mesh.voh_range(middle)) around.push_back(h);
  const SurfacePoint from = point_on_edge(chart.mesh, around[0], 0.2);
  const SurfacePoint to = point_on_edge(chart.mesh, around[around.size() / 2], 0.2);
  const auto line = walk.line(from, to, 10);
  ASSERT_TRUE(line.has_value());
  EXPECT_TRUE(std::any_of(line->between.begin(), line->between.end(),
                          [&](const PathPoint& point) { return point.vertex == middle; }));
}

TEST(StraightWalk, StaysWhereABarrierIsInTheWay) {
  const Chart chart = test::chart_of(bumpy_sheet());
  const CutMask barriers(chart.mesh.n_edges(), 1);
  const StraightWalk walk(chart.mesh, barriers);
  const SurfacePoint start = SurfacePoint::in_face(chart.mesh.face_handle(100), Planar(0.01, 0.01));
  const SurfacePoint end = walk.step(start, Planar(1, 0));
  EXPECT_EQ(end.face, start.face);
  EXPECT_EQ(end.place, start.place);
}

}  // namespace
}  // namespace wirewarp::test_relax_lines
