// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/planar.h"
#include "test_meshes.h"
#include "warp/inner/interior_placement.h"
#include "warp/inner/mean_value.h"

namespace wirewarp::test_interior_placement {
namespace {

/// A jittered grid and its network. The network is the outline and, if `crossed` is true, wires along the middle row
/// and column.
struct GridChart {
  GridChart(int n, bool crossed, const test::Surface& surface) {
    FlattenInput input = test::jittered_grid(n, 0.3, surface);
    if (crossed) test::add_net(input, n, {n / 2});
    chart = test::chart_of(input);
    network = build_wire_network(chart);
    on_network.resize(chart.mesh.n_vertices());
    for (const WireEdge& edge : network.edges) {
      const HalfedgeHandle h = chart.mesh.halfedge_handle(edge.edge, 0);
      for (const VertexHandle v : {chart.mesh.from_vertex_handle(h), chart.mesh.to_vertex_handle(h)}) {
        on_network[v.idx()] = true;
      }
    }
  }

  Chart chart;
  WireNetwork network;
  std::vector<bool> on_network;
};

Eigen::Vector3d tilted_plane(double x, double y) { return {x + 0.2 * y, 0.9 * y - 0.1 * x, 0.7 * x - 0.4 * y + 3}; }

Eigen::Vector3d bumps(double x, double y) { return {x, y, 0.2 * std::sin(5 * x) * std::cos(4 * y)}; }

/// Returns tan(α/2) of the angle α at a between b and c, computed from the angle.
double literal_tan_half(const HalfEdgeMesh& mesh, VertexHandle a, VertexHandle b, VertexHandle c) {
  const OpenMesh::Vec3d ab = mesh.point(b) - mesh.point(a), ac = mesh.point(c) - mesh.point(a);
  return std::tan(std::atan2(OpenMesh::cross(ab, ac).norm(), OpenMesh::dot(ab, ac)) / 2);
}

/// Returns the mean value weight of a neighbor, not normalized, from the two triangles at the edge to this neighbor.
double literal_weight(const HalfEdgeMesh& mesh, HalfedgeHandle to_neighbor) {
  const VertexHandle center = mesh.from_vertex_handle(to_neighbor), neighbor = mesh.to_vertex_handle(to_neighbor);
  const VertexHandle left = mesh.to_vertex_handle(mesh.next_halfedge_handle(to_neighbor));
  const HalfedgeHandle back = mesh.opposite_halfedge_handle(to_neighbor);
  const VertexHandle right = mesh.to_vertex_handle(mesh.next_halfedge_handle(back));
  return (literal_tan_half(mesh, center, neighbor, left) + literal_tan_half(mesh, center, neighbor, right)) /
         (mesh.point(neighbor) - mesh.point(center)).norm();
}

TEST(MeanValue, IsAccurateAtAnAngleNearPi) {
  // A fan around the origin, which is at the height h above the edge between ring vertices 0 and 2.
  const double h = 1e-9;
  HalfEdgeMesh mesh;
  const VertexHandle center = mesh.add_vertex({0, 0, 0});
  const std::vector<OpenMesh::Vec3d> points{{1, -h, 0}, {0, 1, 0}, {-2, -h, 0}};
  for (const OpenMesh::Vec3d& point : points) mesh.add_vertex(point);
  for (int j = 1; j <= 3; ++j) mesh.add_face(center, VertexHandle(j), VertexHandle(j % 3 + 1));

  const double below_0 = std::atan(h), below_2 = std::atan(h / 2);  // angles to the horizontal
  const double tan_01 = std::tan((kPi / 2 + below_0) / 2), tan_12 = std::tan((kPi / 2 + below_2) / 2);
  const double tan_20 = 1 / std::tan((below_2 + below_0) / 2);  // tan(π/2 - x) = 1 / tan x
  const std::vector<double> expected{(tan_20 + tan_01) / points[0].norm(), tan_01 + tan_12,
                                     (tan_12 + tan_20) / points[2].norm()};
  const double sum = expected[0] + expected[1] + expected[2];
  std::vector<WeightedVertex> ring;
  mean_value_weights(mesh, center, ring);
  ASSERT_EQ(ring.size(), 3u);
  for (const auto& [neighbor, weight] : ring) {
    const double literal = expected[neighbor.idx() - 1] / sum;
    EXPECT_NEAR(weight, literal, 1e-14 * literal);
  }
}

TEST(InteriorPlacement, ReproducesAffineMapsOfAPlane) {
  const GridChart grid(20, true, tilted_plane);
  const InteriorPlacement placement(grid.chart, grid.network);
  EXPECT_EQ(placement.factorizations(), 1);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> entry(-2.0, 2.0);
  for (int trial = 0; trial < 3; ++trial) {
    const Eigen::Matrix<double, 2, 3> linear = Eigen::Matrix<double, 2, 3>::NullaryExpr([&] { return entry(random); });
    const Eigen::Vector2d shift(entry(random), entry(random));
    Positions2 expected(grid.on_network.size(), 2);
    for (const VertexHandle vertex : grid.chart.mesh.vertices()) {
      const OpenMesh::Vec3d& p = grid.chart.mesh.point(vertex);
      expected.row(vertex.idx()) = (linear * Eigen::Vector3d(p[0], p[1], p[2]) + shift).transpose();
    }
    Positions2 uv = expected;
    for (int v = 0; v < uv.rows(); ++v)
      if (!grid.on_network[v]) uv.row(v).setConstant(std::numeric_limits<double>::quiet_NaN());
    placement.place(uv);
    EXPECT_LT((uv - expected).cwiseAbs().maxCoeff(), 1e-12);  // NaN fails, too
  }
}

TEST(InteriorPlacement, PutsEveryVertexAtTheMeanOfItsNeighbors) {
  const GridChart grid(30, false, bumps);
  const HalfEdgeMesh& mesh = grid.chart.mesh;
  Positions2 uv(mesh.n_vertices(), 2);
  for (const VertexHandle vertex : mesh.vertices())
    uv.row(vertex.idx()) << std::exp(mesh.point(vertex)[0]), std::sin(3 * mesh.point(vertex)[1]);
  const Positions2 given = uv;
  InteriorPlacement(grid.chart, grid.network).place(uv);
  for (const VertexHandle vertex : mesh.vertices()) {
    if (grid.on_network[vertex.idx()]) {
      EXPECT_EQ(uv.row(vertex.idx()), given.row(vertex.idx()));
      continue;
    }
    Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
    double sum = 0;
    for (const HalfedgeHandle half_edge : mesh.voh_range(vertex)) {
      const double weight = literal_weight(mesh, half_edge);
      mean += weight * uv.row(mesh.to_vertex_handle(half_edge).idx());
      sum += weight;
    }
    EXPECT_LT((mean / sum - uv.row(vertex.idx())).norm(), 1e-14 * uv.norm());
  }
}

TEST(InteriorPlacement, FactorizesNothingIfEveryVertexIsOnTheNetwork) {
  const GridChart grid(2, true, bumps);
  const InteriorPlacement placement(grid.chart, grid.network);
  EXPECT_EQ(placement.factorizations(), 0);
  Positions2 uv = Positions2::Constant(9, 2, 0.5);
  placement.place(uv);
  EXPECT_EQ(uv, Positions2::Constant(9, 2, 0.5));
}

}  // namespace
}  // namespace wirewarp::test_interior_placement
