// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "base/planar.h"
#include "processed_chart.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_process_topology {
namespace {

using test::process;
using test::Processed;
using test::stretch_of_flattening;

/// The input with a square ring of edges around (i, j), of half-width k, as a wire.
void add_ring(FlattenInput& input, int nx, int i, int j, int k) {
  const auto vertex = [&](int x, int y) { return x + (nx + 1) * y; };
  std::vector<int> chain;
  for (int x = -k; x < k; ++x) chain.push_back(vertex(i + x, j - k));
  for (int y = -k; y < k; ++y) chain.push_back(vertex(i + k, j + y));
  for (int x = k; x > -k; --x) chain.push_back(vertex(i + x, j + k));
  for (int y = k; y > -k; --y) chain.push_back(vertex(i - k, j + y));
  chain.push_back(chain.front());
  test::add_wire(input, chain);
}

/// Vertices of row j from column `first` to column `last`.
std::vector<int> row_part(int nx, int j, int first, int last) {
  const std::vector<int> row = test::grid_row(nx, j);
  return {row.begin() + first, row.begin() + last + 1};
}

TEST(ProcessTopology, LeavesASoundNetworkUntouched) {
  EXPECT_FALSE(process_topology(test::charts_of(test::quarter_sphere(6)).charts[0]));
  EXPECT_FALSE(process_topology(test::charts_of(test::flat_rectangle(5, 5, 1, 1)).charts[0])) << "no wires, one loop";
  FlattenInput dart = test::flat_rectangle(6, 6, 1, 1);
  std::vector<int> seam = test::grid_column(6, 6, 3);
  seam.resize(4);
  test::add_seam(dart, seam);
  EXPECT_FALSE(process_topology(test::charts_of(dart).charts[0])) << "a dart is boundary";
}

TEST(ProcessTopology, AWireEndingInsideGoesStraightOn) {
  const int n = 8;
  FlattenInput input = test::flat_rectangle(n, n, 8, 8);
  test::add_wire(input, {4 * 9, 4 * 9 + 1, 4 * 9 + 2, 5 * 9 + 3});  // the last edge runs along a diagonal
  const Processed p = process(input);
  ASSERT_EQ(p.num_helpers(), 1u);
  EXPECT_EQ(p.refined.mesh.n_vertices(), p.chart.mesh.n_vertices()) << "the diagonals are edges already";
  EXPECT_EQ(p.refined.wire_parts[1].half_edges.size(), 3u);
  EXPECT_EQ(p.refined.mesh.to_vertex_handle(p.refined.wire_parts[1].half_edges.back()), VertexHandle(8 * 9 + 6));
}

TEST(ProcessTopology, ATailOneEdgeFromTheBoundary) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_wire(input, row_part(n, 3, 0, n - 1));
  const Processed p = process(input);
  ASSERT_EQ(p.num_helpers(), 1u);
  EXPECT_EQ(p.refined.wire_parts[1].half_edges.size(), 1u);
}

TEST(ProcessTopology, AWireWithBothEndsInside) {
  const int n = 8;
  FlattenInput input = test::saddle(n, 0.4);
  test::add_wire(input, row_part(n, 3, 3, 5));
  const Processed p = process(input);
  EXPECT_EQ(p.num_helpers(), 2u);
}

TEST(ProcessTopology, ASingleEdgeAsAWire) {
  FlattenInput input = test::saddle(8, 0.4);
  test::add_wire(input, {4 + 9 * 4, 5 + 9 * 4});
  EXPECT_EQ(process(input).num_helpers(), 2u);
}

TEST(ProcessTopology, SeveralFloatingWires) {
  const int n = 12;
  FlattenInput input = test::saddle(n, 0.3);
  test::add_wire(input, row_part(n, 3, 3, 6));
  test::add_wire(input, row_part(n, 6, 5, 9));
  test::add_wire(input, row_part(n, 9, 2, 4));
  std::vector<int> column = test::grid_column(n, n, 10);
  test::add_wire(input, {column.begin() + 4, column.begin() + 9});
  process(input);
}

TEST(ProcessTopology, ATailPointingAlongAnExistingWire) {
  const int n = 10;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_wire(input, row_part(n, 5, 0, 4));
  test::add_wire(input, row_part(n, 5, 6, 8));
  const Processed p = process(input);
  // One helper closes the gap for both, one leads the second wire on to the boundary.
  EXPECT_EQ(p.num_helpers(), 2u);
  EXPECT_EQ(p.refined.wire_parts[2].half_edges.size(), 2u);
}

TEST(ProcessTopology, ATailWhosePathGoesRoundATube) {
  const int nx = 16;
  FlattenInput input = test::cylinder_tube(nx, 6, 1, 2);
  const std::vector<int> ring = test::tube_ring(nx, 3);
  test::add_wire(input, {ring.begin(), ring.begin() + 9});
  const Processed p = process(input);  // closes into a ring, then four to each end of the tube
  EXPECT_EQ(p.num_helpers(), 1u + 4 + 4);
}

TEST(ProcessTopology, ATailWhoseGeodesicSpiralsTakesTheShortestWayOut) {
  const int nx = 16;
  const int ny = 40;
  // Each ring climbs by a tenth of an edge from line to line: the tail's geodesic is a flat helix.
  FlattenInput input = test::make_tube(nx, ny, [&](double s, double t) {
    return Eigen::Vector3d(std::cos(2 * kPi * s), std::sin(2 * kPi * s), 6 * t + 0.3 * s * (1 - s));
  });
  const std::vector<int> ring = test::tube_ring(nx, ny / 2);
  test::add_wire(input, {ring.begin() + 1, ring.begin() + 4});
  const Processed p = process(input);
  for (const WirePart& part : p.refined.wire_parts) {
    double length = 0;
    for (const HalfedgeHandle h : part.half_edges) length += edge_length(p.refined.mesh, h);
    EXPECT_LT(length, std::hypot(6, kPi)) << "from end to end and half around";
  }
}

TEST(ProcessTopology, ATailWhosePathHitsItsOwnWire) {
  const int n = 12;
  FlattenInput input = test::saddle(n, 0.2);
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  // From the left side inwards, round a hook and back towards itself.
  test::add_wire(input, {vertex(0, 4), vertex(1, 4), vertex(2, 4), vertex(3, 4), vertex(4, 4), vertex(5, 4),
                         vertex(6, 4), vertex(7, 4), vertex(7, 5), vertex(7, 6), vertex(7, 7), vertex(6, 7),
                         vertex(5, 7), vertex(4, 7), vertex(4, 6)});
  const Processed p = process(input);
  EXPECT_EQ(p.num_helpers(), 1u + 3) << "the hook closed, and three more besides the stem";
}

TEST(ProcessTopology, AChartWithoutWiresAndTwoLoops) {
  const Processed p = process(test::flat_annulus(24, 5, 1, 2));
  EXPECT_EQ(p.num_helpers(), 4u);
  // The four lie a quarter of the loop apart.
  std::set<int> starts;
  for (const WirePart& part : p.refined.wire_parts) {
    starts.insert(p.refined.mesh.from_vertex_handle(part.half_edges.front()).idx() % 6);
  }
  EXPECT_EQ(starts.size(), 1u);
  EXPECT_EQ(process(test::cylinder_tube(12, 3, 1, 1)).num_helpers(), 4u);
  EXPECT_EQ(process(test::sphere_band(18, 6, 0.8)).num_helpers(), 4u);
}

TEST(ProcessTopology, LoopsOneTriangleApart) {
  EXPECT_EQ(process(test::flat_annulus(12, 1, 1, 1.2)).num_helpers(), 4u);
  EXPECT_EQ(process(test::cylinder_tube(3, 1, 1, 1)).num_helpers(), 3u) << "a loop of three vertices";
}

TEST(ProcessTopology, AChartWithThreeHoles) {
  const FlattenInput plate = test::keep_faces(test::flat_rectangle(24, 12, 6, 3), [](const Eigen::Vector3d& p) {
    const auto in_hole = [&](double x, double y) { return std::abs(p.x() - x) < 0.5 && std::abs(p.y() - y) < 0.5; };
    return !in_hole(1, 1) && !in_hole(3, 2) && !in_hole(5, 1);
  });
  const Processed p = process(plate);
  for (std::size_t i = 1; i < 4; ++i) {
    std::set<int> hole;
    for (const HalfedgeHandle h : p.chart.boundary_loops[i]) hole.insert(p.chart.mesh.from_vertex_handle(h).idx());
    std::size_t num_ends = 0;
    for (const WirePart& part : p.refined.wire_parts) {
      num_ends += hole.count(p.refined.mesh.from_vertex_handle(part.half_edges.front()).idx()) +
                  hole.count(p.refined.mesh.to_vertex_handle(part.half_edges.back()).idx());
    }
    EXPECT_EQ(num_ends, 4u) << "a path from another hole counts";
  }
}

TEST(ProcessTopology, AHoleThatOneWireJoinsGetsThreeMore) {
  FlattenInput input = test::flat_annulus(24, 6, 1, 2);
  test::add_wire(input, test::tube_line(24, 6, 5));
  EXPECT_EQ(process(input).num_helpers(), 3u);
}

TEST(ProcessTopology, AClosedRingWire) {
  const int n = 10;
  FlattenInput input = test::saddle(n, 0.3);
  add_ring(input, n, 5, 5, 2);
  EXPECT_EQ(process(input).num_helpers(), 4u);
}

TEST(ProcessTopology, ARingInsideARing) {
  const int n = 16;
  FlattenInput input = test::saddle(n, 0.3);
  add_ring(input, n, 8, 8, 2);
  add_ring(input, n, 8, 8, 5);
  EXPECT_EQ(process(input).num_helpers(), 8u);
}

TEST(ProcessTopology, ARingAroundOneTriangle) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  test::add_wire(input, {vertex(3, 3), vertex(4, 3), vertex(4, 4), vertex(3, 3)});
  EXPECT_EQ(process(input).num_helpers(), 3u);
}

TEST(ProcessTopology, AFloatingWireInsideARing) {
  const int n = 16;
  FlattenInput input = test::saddle(n, 0.3);
  add_ring(input, n, 8, 8, 5);
  test::add_wire(input, row_part(n, 8, 7, 9));
  const Processed p = process(input);
  EXPECT_EQ(p.num_helpers(), 2u + 4);
}

TEST(ProcessTopology, ASlitInside) {
  const int n = 10;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, row_part(n, 5, 3, 7));
  EXPECT_EQ(process(input).num_helpers(), 4u);
  FlattenInput short_slit = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(short_slit, row_part(n, 5, 3, 4));
  EXPECT_EQ(process(short_slit).num_helpers(), 2u) << "two vertices, one path from each";
}

TEST(ProcessTopology, ATailTowardsADart) {
  const int n = 10;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, row_part(n, 5, 7, n));
  test::add_wire(input, row_part(n, 5, 0, 4));
  const Processed p = process(input);
  ASSERT_EQ(p.num_helpers(), 1u);
  EXPECT_EQ(p.refined.wire_parts[1].half_edges.size(), 3u) << "to the tip of the dart";
}

TEST(ProcessTopology, WhatIsFlatFlattensToItself) {
  FlattenInput floating = test::flat_rectangle(12, 12, 1, 1);
  test::add_wire(floating, row_part(12, 5, 3, 7));
  add_ring(floating, 12, 8, 9, 1);
  EXPECT_LT(stretch_of_flattening(process(floating).refined), 1e-8);
  EXPECT_LT(stretch_of_flattening(process(test::flat_annulus(24, 5, 1, 2)).refined), 1e-8);
  EXPECT_LT(stretch_of_flattening(process(test::flat_plate_with_two_holes(8)).refined), 1e-8);
}

TEST(ProcessTopology, DoesNotDependOnScale) {
  std::vector<std::size_t> num_vertices;
  for (const double scale : {std::ldexp(1, -20), 1.0, std::ldexp(1, 20)}) {  // the same rounding
    FlattenInput input = test::saddle(12, 0.3);
    input.vertices *= scale;
    add_ring(input, 12, 5, 6, 2);
    test::add_wire(input, row_part(12, 3, 3, 6));
    num_vertices.push_back(process(input).refined.mesh.n_vertices());
  }
  EXPECT_EQ(num_vertices[0], num_vertices[1]);
  EXPECT_EQ(num_vertices[2], num_vertices[1]);
}

/// A wandering chain of edges that crosses neither itself nor earlier chains.
std::vector<int> random_chain(const Chart& chart, std::set<int>& used, std::mt19937& random) {
  std::vector<int> chain;
  VertexHandle v(static_cast<int>(random() % chart.mesh.n_vertices()));
  const std::size_t goal = 2 + random() % 12;
  while (used.insert(v.idx()).second) {
    chain.push_back(v.idx());
    std::vector<VertexHandle> next;
    for (const VertexHandle w : chart.mesh.vv_range(v)) {
      if (used.count(w.idx()) == 0) next.push_back(w);
    }
    if (next.empty() || chain.size() == goal) break;
    v = next[random() % next.size()];
  }
  return chain;
}

TEST(ProcessTopology, WanderingWiresOnAnySurface) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    FlattenInput input;
    switch (seed % 4) {
      case 0:
        input = test::saddle(9, 0.5);
        break;
      case 1:
        input = test::sphere_band(14, 7, 0.9);
        break;
      case 2:
        input = test::flat_plate_with_two_holes(4);
        break;
      default:
        input = test::flat_annulus(16, 4, 1, 2);
        break;
    }
    const Chart chart = test::charts_of(input).charts[0];
    std::set<int> used;
    const std::size_t num_wires = 1 + random() % 6;
    for (std::size_t w = 0; w < num_wires; ++w) {
      const std::vector<int> chain = random_chain(chart, used, random);
      if (chain.size() > 1) test::add_wire(input, chain);
    }
    if (process_topology(test::charts_of(input).charts[0])) process(input);
  }
}

}  // namespace
}  // namespace wirewarp::test_process_topology
