// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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

std::vector<int> row_part(int nx, int j, int first, int last) {
  return test::section(test::grid_row(nx, j), first, last);
}

TEST(ProcessTopology, LeavesASoundNetworkUntouched) {
  EXPECT_FALSE(process_topology(test::chart_of(test::quarter_sphere(6))));
  EXPECT_FALSE(process_topology(test::chart_of(test::flat_rectangle(5, 5, 1, 1)))) << "no wires, one loop";
  FlattenInput dart = test::flat_rectangle(6, 6, 1, 1);
  test::add_seam(dart, test::section(test::grid_column(6, 6, 3), 0, 3));
  EXPECT_FALSE(process_topology(test::chart_of(dart))) << "a dart is part of the outline";
}

TEST(ProcessTopology, AWireEndingInsideGoesStraightOn) {
  const int n = 8;
  FlattenInput input = test::flat_rectangle(n, n, 8, 8);
  test::add_wire(input, {4 * 9, 4 * 9 + 1, 4 * 9 + 2, 5 * 9 + 3});  // the last edge runs along a diagonal
  Chart mapped = test::chart_of(input);
  mapped.free_map.emplace(Positions2::Zero(81, 2));
  EXPECT_FALSE(process_topology(mapped)->free_map) << "the mesh may have changed";
  const Processed p = process(input);
  ASSERT_EQ(p.num_helpers(), 1u);
  EXPECT_EQ(p.refined.mesh.n_vertices(), p.chart.mesh.n_vertices()) << "the diagonals are edges already";
  EXPECT_EQ(p.refined.wire_parts[1].half_edges.size(), 3u);
  EXPECT_EQ(p.refined.mesh.to_vertex_handle(p.refined.wire_parts[1].half_edges.back()), VertexHandle(8 * 9 + 6));
}

FlattenInput with_wires(FlattenInput input, const std::vector<std::vector<int>>& chains) {
  for (const std::vector<int>& chain : chains) test::add_wire(input, chain);
  return input;
}

FlattenInput with_seam(FlattenInput input, const std::vector<int>& chain) {
  test::add_seam(input, chain);
  return input;
}

int at(int nx, int i, int j) { return i + (nx + 1) * j; }

/// Returns a wire in the form of a hook, which runs from the left side inwards, around, and back towards itself.
std::vector<int> hook() {
  std::vector<int> chain = row_part(12, 4, 0, 7);
  for (const auto& [i, j] : {std::pair(7, 5), {7, 6}, {7, 7}, {6, 7}, {5, 7}, {4, 7}, {4, 6}}) {
    chain.push_back(at(12, i, j));
  }
  return chain;
}

TEST(HelperWires, AreAsFewAsTheNetworkNeeds) {
  const auto square = [](int n) { return test::flat_rectangle(n, n, 1, 1); };
  struct Network {
    const char* name;
    FlattenInput input;
    std::size_t num_helpers;
  };
  for (const Network& network : std::vector<Network>{
           {"tail one edge from the outline", with_wires(square(6), {row_part(6, 3, 0, 5)}), 1},
           {"both ends inside", with_wires(test::saddle(8, 0.4), {row_part(8, 3, 3, 5)}), 2},
           {"one edge", with_wires(test::saddle(8, 0.4), {row_part(8, 4, 4, 5)}), 2},
           // One helper wire closes the gap between the wires. Another leads from the second wire to the outline.
           {"tail along a wire", with_wires(square(10), {row_part(10, 5, 0, 4), row_part(10, 5, 6, 8)}), 2},
           // One helper wire closes the wire into a ring, and four more lead from the ring to each end of the tube.
           {"tail around a tube",
            with_wires(test::cylinder_tube(16, 6, 1, 2), {test::section(test::tube_ring(16, 3), 0, 8)}), 1 + 4 + 4},
           // One helper wire closes the hook. The stem and three more helper wires connect the hook with the outline.
           {"tail to its own wire", with_wires(test::saddle(12, 0.2), {hook()}), 1 + 3},
           {"two loops", test::cylinder_tube(12, 3, 1, 1), 4},
           {"two loops on a sphere", test::sphere_band(18, 6, 0.8), 4},
           {"loops one triangle apart", test::flat_annulus(12, 1, 1, 1.2), 4},
           {"loops of three vertices", test::cylinder_tube(3, 1, 1, 1), 3},
           {"hole with one wire", with_wires(test::flat_annulus(24, 6, 1, 2), {test::tube_line(24, 6, 5)}), 3},
           {"ring", with_wires(test::saddle(10, 0.3), {test::grid_square(10, 5, 5, 2)}), 4},
           {"ring in a ring",
            with_wires(test::saddle(16, 0.3), {test::grid_square(16, 8, 8, 2), test::grid_square(16, 8, 8, 5)}), 8},
           {"ring around one triangle", with_wires(square(6), {{at(6, 3, 3), at(6, 4, 3), at(6, 4, 4), at(6, 3, 3)}}),
            3},
           {"wire in a ring",
            with_wires(test::saddle(16, 0.3), {test::grid_square(16, 8, 8, 5), row_part(16, 8, 7, 9)}), 2 + 4},
           {"slit", with_seam(square(10), row_part(10, 5, 3, 7)), 4},
           {"slit of one edge", with_seam(square(10), row_part(10, 5, 3, 4)), 2},  // one for each vertex
           {"tail towards a dart", with_wires(with_seam(square(10), row_part(10, 5, 7, 10)), {row_part(10, 5, 0, 4)}),
            1},
       }) {
    SCOPED_TRACE(network.name);
    EXPECT_EQ(process(network.input).num_helpers(), network.num_helpers);
  }
}

TEST(ProcessTopology, ATailWithASpiralGeodesicTakesTheShortestPath) {
  const int nx = 16, ny = 40;
  // Each ring rises and falls slightly. So the wire is not level, and its straight continuation is a flat helix.
  FlattenInput input = test::make_tube(nx, ny, [&](double s, double t) {
    return Eigen::Vector3d(std::cos(2 * kPi * s), std::sin(2 * kPi * s), 6 * t + 0.3 * s * (1 - s));
  });
  test::add_wire(input, test::section(test::tube_ring(nx, ny / 2), 1, 3));
  const Processed p = process(input);
  for (const WirePart& part : p.refined.wire_parts) {
    double length = 0;
    for (const HalfedgeHandle h : part.half_edges) length += edge_length(p.refined.mesh, h);
    EXPECT_LT(length, std::hypot(6, kPi)) << "shorter than from one end to the other and half around";
  }
}

TEST(ProcessTopology, FlatChartsKeepTheirShape) {
  FlattenInput floating = test::flat_rectangle(12, 12, 1, 1);
  test::add_wire(floating, row_part(12, 5, 3, 7));
  test::add_wire(floating, test::grid_square(12, 8, 9, 1));
  EXPECT_LT(stretch_of_flattening(process(floating).refined), 1e-8);
  EXPECT_LT(stretch_of_flattening(process(test::flat_annulus(24, 5, 1, 2)).refined), 1e-8);
  EXPECT_LT(stretch_of_flattening(process(test::flat_plate_with_two_holes(8)).refined), 1e-8);
}

TEST(ProcessTopology, DoesNotDependOnScale) {
  std::vector<std::size_t> num_vertices;
  for (const double scale : {std::ldexp(1, -20), 1.0, std::ldexp(1, 20)}) {  // powers of two, for equal rounding
    FlattenInput input = test::saddle(12, 0.3);
    input.vertices *= scale;
    test::add_wire(input, test::grid_square(12, 5, 6, 2));
    test::add_wire(input, row_part(12, 3, 3, 6));
    num_vertices.push_back(process(input).refined.mesh.n_vertices());
  }
  EXPECT_EQ(num_vertices[0], num_vertices[1]);
  EXPECT_EQ(num_vertices[2], num_vertices[1]);
}

}  // namespace
}  // namespace wirewarp::test_process_topology
