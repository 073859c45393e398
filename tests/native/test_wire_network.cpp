// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/planar.h"
#include "surface/network/wire_lines.h"
#include "surface/network/wire_network.h"
#include "test_meshes.h"

namespace wirewarp::test_wire_network {
namespace {

struct Network {
  explicit Network(const FlattenInput& input) : charts(test::charts_of(input)), chart(charts.charts[0]) {
    network = build_wire_network(chart);
  }
  Charts charts;
  const Chart& chart;
  WireNetwork network;
};

std::size_t num_loop_nodes(const WireNetwork& network) {
  std::size_t count = 0;
  for (const WirePatch& patch : network.patches) {
    for (const auto& loop : patch.loops) count += loop.size();
  }
  return count;
}

void expect_closed_walks(const WireNetwork& network) {
  EXPECT_EQ(num_loop_nodes(network), network.nodes.size()) << "every node in one loop";
  for (const WirePatch& patch : network.patches) {
    for (const auto& loop : patch.loops) {
      for (std::size_t b = 0; b < loop.size(); ++b) {
        const WireNode& node = network.nodes[static_cast<std::size_t>(loop[b].node)];
        const WireHalfEdge before = loop[(b + loop.size() - 1) % loop.size()].half_edge;
        EXPECT_EQ(node.in.edge, before.edge);
        EXPECT_EQ(node.in.reversed, before.reversed);
        EXPECT_EQ(node.out.edge, loop[b].half_edge.edge);
      }
    }
  }
}

TEST(WireNetwork, CrossingWiresMakeFourPatchesAndFourNodesWhereTheyCross) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_wire(input, test::grid_row(n, 3));
  test::add_wire(input, test::grid_column(n, n, 2));
  const Network p(input);
  expect_closed_walks(p.network);
  EXPECT_EQ(p.network.patches.size(), 4u);
  EXPECT_EQ(p.network.edges.size(), static_cast<std::size_t>(4 * n + 2 * n));
  // Each boundary vertex has one node, or two if a wire ends there. Inner vertices of wires have two nodes, and the
  // crossing has four nodes.
  EXPECT_EQ(p.network.nodes.size(), static_cast<std::size_t>(4 * n + 4 + 2 * (2 * n - 3) - 2 + 4));
  std::size_t most = 0;
  for (const auto& nodes : p.network.inner_vertex_nodes) most = std::max(most, nodes.size());
  EXPECT_EQ(most, 4u);
}

TEST(WireNetwork, GaussBonnet) {
  // On every disk, the turning of the outline and the angle deficits inside add up to 2π.
  const Network p(test::quarter_sphere(8));
  const HalfEdgeMesh& mesh = p.chart.mesh;
  double sum = 0;
  std::vector<double> node_angle(mesh.n_vertices(), 0);
  for (const WireNode& node : p.network.nodes)
    node_angle[static_cast<std::size_t>(node.vertex.idx())] += node.surface_angle;
  for (const HalfedgeHandle h : p.chart.boundary_loops[0]) {
    sum += kPi - node_angle[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())];
  }
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_boundary(v)) continue;
    sum += 2 * kPi;
    for (const HalfedgeHandle h : mesh.voh_range(v)) {
      const auto along = mesh.point(mesh.to_vertex_handle(h)) - mesh.point(v);
      const auto next = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))) - mesh.point(v);
      sum -= std::acos((along | next) / (along.norm() * next.norm()));
    }
  }
  EXPECT_NEAR(sum, 2 * kPi, 1e-11);
}

TEST(WireNetwork, ATailHasOneNodeAndAHoleItsOwnLoop) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  std::vector<int> half = test::grid_row(n, 3);
  half.resize(4);
  test::add_wire(input, half);
  const Network tail(input);
  expect_closed_walks(tail.network);
  EXPECT_EQ(std::count_if(tail.network.nodes.begin(), tail.network.nodes.end(),
                          [](const WireNode& node) { return node.is_tail; }),
            1);

  const Network annulus(test::flat_annulus(12, 2, 1, 2));
  expect_closed_walks(annulus.network);
  ASSERT_EQ(annulus.network.patches.size(), 1u);
  EXPECT_EQ(annulus.network.patches[0].loops.size(), 2u);
  ASSERT_EQ(annulus.network.holes.size(), 1u);
  EXPECT_EQ(annulus.network.holes[0].size(), 12u);
}

std::size_t bends_past_corners(const WireLines& lines) {
  return static_cast<std::size_t>(
      std::count_if(lines.bends.begin(), lines.bends.end(), [](const LineBend& bend) { return bend.num_sectors > 1; }));
}

TEST(WireLines, ContinueThroughCrossingsAndWhereWiresMeetTheOutline) {
  FlattenInput input = test::flat_rectangle(6, 6, 1, 1);
  test::add_wire(input, test::grid_row(6, 3));
  test::add_wire(input, test::grid_column(6, 6, 2));
  const Network crossed(input);
  const WireLines lines = find_lines(crossed.chart, crossed.network);
  EXPECT_EQ(lines.corners.size(), 4u + 4u * 2u);
  EXPECT_EQ(lines.bends.size(), 24u + 2u * 2u * 5u)
      << "one bend at each outline vertex, two at each inner vertex of a wire";
  EXPECT_EQ(bends_past_corners(lines), 4u + 4u);
  for (const LineBend& bend : lines.bends) {
    const bool is_corner_of_square = std::abs(bend.node.surface_angle - kPi / 2) < 1e-12;
    EXPECT_TRUE(is_corner_of_square || std::abs(bend.node.surface_angle - kPi) < 1e-12) << bend.node.surface_angle;
  }
}

TEST(WireLines, TwoWiresEndToEndAreOneLineUnlessAThirdWireMeetsThem) {
  FlattenInput input = test::flat_rectangle(6, 6, 1, 1);
  const std::vector<int> row = test::grid_row(6, 3);
  test::add_wire(input, {row.begin(), row.begin() + 4});
  test::add_wire(input, {row.begin() + 3, row.end()});
  const Network joined(input);
  EXPECT_EQ(find_lines(joined.chart, joined.network).corners.size(), 2u * 2u) << "only where they meet the outline";
  std::vector<int> column = test::grid_column(6, 6, 3);
  column.resize(4);
  test::add_wire(input, column);
  const Network met(input);
  EXPECT_EQ(find_lines(met.chart, met.network).corners.size(), 3u * 2u + 3u);
}

}  // namespace
}  // namespace wirewarp::test_wire_network
