// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

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

/// Returns the vertices of row j from column `first` to column `last`.
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
  EXPECT_FALSE(process_topology(test::charts_of(dart).charts[0])) << "a dart is part of the outline";
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

FlattenInput with_wires(FlattenInput input, const std::vector<std::vector<int>>& chains) {
  for (const std::vector<int>& chain : chains) test::add_wire(input, chain);
  return input;
}

FlattenInput with_seam(FlattenInput input, const std::vector<int>& chain) {
  test::add_seam(input, chain);
  return input;
}

struct Network {
  const char* name;
  FlattenInput input;
  std::size_t num_helpers;
};

/// Names the case in test reports.
void PrintTo(const Network& network, std::ostream* out) { *out << network.name; }

class HelperWires : public testing::TestWithParam<Network> {};

TEST_P(HelperWires, AreAsFewAsTheNetworkNeeds) {
  EXPECT_EQ(process(GetParam().input).num_helpers(), GetParam().num_helpers);
}

int at(int nx, int i, int j) { return i + (nx + 1) * j; }

/// Returns a wire in the form of a hook, which runs from the left side inwards, around, and back towards itself.
std::vector<int> hook() {
  std::vector<int> chain = row_part(12, 4, 0, 7);
  for (const int v :
       {at(12, 7, 5), at(12, 7, 6), at(12, 7, 7), at(12, 6, 7), at(12, 5, 7), at(12, 4, 7), at(12, 4, 6)}) {
    chain.push_back(v);
  }
  return chain;
}

std::vector<int> half_of_a_ring() {
  const std::vector<int> ring = test::tube_ring(16, 3);
  return {ring.begin(), ring.begin() + 9};
}

INSTANTIATE_TEST_SUITE_P(
    ProcessTopology, HelperWires,
    testing::Values(
        Network{"tail_one_edge_from_the_outline", with_wires(test::flat_rectangle(6, 6, 1, 1), {row_part(6, 3, 0, 5)}),
                1},
        Network{"both_ends_inside", with_wires(test::saddle(8, 0.4), {row_part(8, 3, 3, 5)}), 2},
        Network{"one_edge", with_wires(test::saddle(8, 0.4), {row_part(8, 4, 4, 5)}), 2},
        // One helper wire closes the gap between both wires, and one helper wire leads from the second wire to the
        // outline.
        Network{"tail_along_a_wire",
                with_wires(test::flat_rectangle(10, 10, 1, 1), {row_part(10, 5, 0, 4), row_part(10, 5, 6, 8)}), 2},
        // One helper wire closes the wire into a ring, and four more lead from the ring to each end of the tube.
        Network{"tail_around_a_tube", with_wires(test::cylinder_tube(16, 6, 1, 2), {half_of_a_ring()}), 1 + 4 + 4},
        // One helper wire closes the hook. The stem and three more helper wires connect the hook with the outline.
        Network{"tail_to_its_own_wire", with_wires(test::saddle(12, 0.2), {hook()}), 1 + 3},
        Network{"two_loops", test::cylinder_tube(12, 3, 1, 1), 4},
        Network{"two_loops_on_a_sphere", test::sphere_band(18, 6, 0.8), 4},
        Network{"loops_one_triangle_apart", test::flat_annulus(12, 1, 1, 1.2), 4},
        Network{"loops_of_three_vertices", test::cylinder_tube(3, 1, 1, 1), 3},
        Network{"hole_with_one_wire", with_wires(test::flat_annulus(24, 6, 1, 2), {test::tube_line(24, 6, 5)}), 3},
        Network{"ring", with_wires(test::saddle(10, 0.3), {test::grid_square(10, 5, 5, 2)}), 4},
        Network{"ring_in_a_ring",
                with_wires(test::saddle(16, 0.3), {test::grid_square(16, 8, 8, 2), test::grid_square(16, 8, 8, 5)}), 8},
        Network{"ring_around_one_triangle",
                with_wires(test::flat_rectangle(6, 6, 1, 1), {{at(6, 3, 3), at(6, 4, 3), at(6, 4, 4), at(6, 3, 3)}}),
                3},
        Network{"wire_in_a_ring",
                with_wires(test::saddle(16, 0.3), {test::grid_square(16, 8, 8, 5), row_part(16, 8, 7, 9)}), 2 + 4},
        Network{"slit", with_seam(test::flat_rectangle(10, 10, 1, 1), row_part(10, 5, 3, 7)), 4},
        // The slit has two vertices, and one helper wire from each vertex.
        Network{"slit_of_one_edge", with_seam(test::flat_rectangle(10, 10, 1, 1), row_part(10, 5, 3, 4)), 2},
        Network{
            "tail_towards_a_dart",
            with_wires(with_seam(test::flat_rectangle(10, 10, 1, 1), row_part(10, 5, 7, 10)), {row_part(10, 5, 0, 4)}),
            1}),
    [](const testing::TestParamInfo<Network>& test) { return std::string(test.param.name); });

TEST(ProcessTopology, ATailWithASpiralGeodesicTakesTheShortestPath) {
  const int nx = 16;
  const int ny = 40;
  // Each ring rises and falls slightly. So the wire is not level, and its straight continuation is a flat helix.
  FlattenInput input = test::make_tube(nx, ny, [&](double s, double t) {
    return Eigen::Vector3d(std::cos(2 * kPi * s), std::sin(2 * kPi * s), 6 * t + 0.3 * s * (1 - s));
  });
  const std::vector<int> ring = test::tube_ring(nx, ny / 2);
  test::add_wire(input, {ring.begin() + 1, ring.begin() + 4});
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
