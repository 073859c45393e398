// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the inner problem of the paper: the angles of the wires, and the places of the vertices between them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/planar.h"
#include "dense_algebra.h"
#include "test_meshes.h"
#include "warp/inner/inner_problem.h"
#include "warp/inner/interior_placement.h"
#include "warp/inner/mean_value.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_inner_problem {
namespace {

Eigen::VectorXd rest_lengths(const WireNetwork& network) {
  Eigen::VectorXd lengths(network.edges.size());
  for (Eigen::Index e = 0; e < lengths.size(); ++e) lengths[e] = network.edges[e].length;
  return lengths;
}

double largest_gap(const std::vector<std::vector<WireHalfEdge>>& loops, const Eigen::VectorXd& headings,
                   const Eigen::VectorXd& lengths) {
  double largest = 0;
  for (const auto& loop : loops) {
    Eigen::Vector2d gap(0, 0);
    double length = 0;
    for (const WireHalfEdge& h : loop) {
      const double along = h.reversed ? -lengths[h.edge] : lengths[h.edge];
      gap += along * Eigen::Vector2d(std::cos(headings[h.edge]), std::sin(headings[h.edge]));
      length += lengths[h.edge];
    }
    largest = std::max(largest, gap.norm() / length);
  }
  return largest;
}

FlattenInput domed_plate_with_two_holes() {
  FlattenInput input = test::flat_plate_with_wires(4);
  for (auto p : input.vertices.rowwise()) {
    const double x = p[0] - 1.5, y = p[1] - 1;
    p[2] = 0.5 * std::exp(-x * x - y * y);
  }
  return input;
}

TEST(InnerProblem, EndsAtMinimaNotAtSaddles) {
  // Patches of the sphere with wires on their axes of symmetry have many stationary points. At the result, the Hessian
  // of the Lagrangian must be positive definite on the null space of the closures.
  for (const double height : {0.8, 1.6}) {
    for (const int n : {2, 4, 8}) {
      FlattenInput input = test::make_grid(n, 2 * n, [&](double s, double t) {
        const double longitude = 0.8 * (2 * s - 1), latitude = height * 0.75 * (2 * t - 1);
        return Eigen::Vector3d(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                               std::sin(latitude));
      });
      test::add_wire(input, test::grid_column(n, 2 * n, n / 2));
      test::add_wire(input, test::grid_row(n, n));
      const Chart chart = test::chart_of(input);
      const WireNetwork network = build_wire_network(chart);
      const Eigen::VectorXd lengths = rest_lengths(network);
      for (const NodeWeight weight : {NodeWeight::length, NodeWeight::uniform}) {
        InnerProblem inner(network, weight);
        const InnerSolution solution = inner.solve(lengths, Inner::minimum);
        EXPECT_TRUE(solution.is_minimum);
        const Eq1 eq1(network, weight);
        KktSystem kkt(eq1, network);
        EXPECT_TRUE(kkt.factor(eq1.laplacian(), eq1.closure_hessian(solution.psi, lengths, solution.multipliers),
                               eq1.closure_jacobian(solution.psi, lengths)))
            << "height " << height << " n " << n;
      }
    }
  }
}

TEST(InnerProblem, TubesReachTheirMinimum) {
  // To close these tubes, edges must turn by so much that the linearized gap is wrong.
  FlattenInput narrow = test::cylinder_tube(28, 4, 1, 0.2);
  test::add_wire(narrow, test::tube_line(28, 4, 3));
  test::add_wire(narrow, test::tube_line(28, 4, 14));
  FlattenInput band = test::sphere_band(24, 6, 0.7);
  test::add_wire(band, test::tube_line(24, 6, 0));
  test::add_wire(band, test::tube_line(24, 6, 9));
  for (const FlattenInput& input : {narrow, band}) {
    const Chart chart = test::chart_of(input);
    const WireNetwork network = build_wire_network(chart);
    InnerProblem inner(network, NodeWeight::length);
    const InnerSolution solution = inner.solve(rest_lengths(network), Inner::minimum);
    EXPECT_TRUE(solution.is_minimum);
    EXPECT_LT(solution.closure_residual, 1e-12);
    EXPECT_LE(solution.num_solves, 16);
  }
}

TEST(InnerProblem, LeavesASaddleWithManySymmetries) {
  // A search for the change of headings that lowers Eq. (1) starts with the symmetry_breaker of Eq1. On a square tube,
  // this start is almost orthogonal to the change.
  const FlattenInput tube = test::make_tube(20, 2, [](double s, double t) {
    const int side = static_cast<int>(std::floor(4 * s + 1e-9)) % 4;
    const double along = 4 * s - side;
    const double x[] = {along, 1, 1 - along, 0}, y[] = {0, along, 1, 1 - along};
    return Eigen::Vector3d(x[side], y[side], 0.4 * t);
  });
  const std::optional<Chart> chart = process_topology(test::chart_of(tube));
  ASSERT_TRUE(chart);
  const WireNetwork network = build_wire_network(*chart);
  InnerProblem inner(network, NodeWeight::length);
  const InnerSolution solution = inner.solve(rest_lengths(network), Inner::minimum);
  EXPECT_TRUE(solution.is_minimum);
  EXPECT_LE(solution.num_solves, 50);
}

TEST(InnerProblem, TheMinimumIsBelowTheFirstFeasiblePoint) {
  const Chart chart = test::chart_of(test::quarter_sphere(12));
  const WireNetwork network = build_wire_network(chart);
  const Eigen::VectorXd lengths = rest_lengths(network);
  InnerProblem inner(network, NodeWeight::length);
  const InnerSolution feasible = inner.solve(lengths, Inner::least_norm);
  const InnerSolution minimum = inner.solve(lengths, Inner::minimum);
  EXPECT_LT(feasible.closure_residual, 1e-12);
  EXPECT_TRUE(std::isnan(feasible.projected_gradient)) << "nothing was minimized";
  const Eq1 eq1(network, NodeWeight::length);
  EXPECT_LT(eq1.angle_variation(minimum.psi), eq1.angle_variation(feasible.psi) * (1 - 1e-6));
}

TEST(InnerProblem, HolesCloseOnlyByConstraintsOfTheirOwn) {
  const Chart chart = test::chart_of(domed_plate_with_two_holes());
  const WireNetwork network = build_wire_network(chart);
  ASSERT_EQ(network.holes.size(), 2u);
  const Eigen::VectorXd lengths = rest_lengths(network);
  InnerProblem with_rows(network, NodeWeight::length);
  const InnerSolution closed = with_rows.solve(lengths, Inner::minimum);
  EXPECT_LT(largest_gap(network.holes, closed.headings, lengths), 1e-12);

  WireNetwork paper = network;
  paper.holes.clear();
  InnerProblem without_rows(paper, NodeWeight::length);
  const InnerSolution open = without_rows.solve(lengths, Inner::minimum);
  EXPECT_LT(open.closure_residual, 1e-12) << "every wire-patch closes nevertheless";
  EXPECT_GT(largest_gap(network.holes, open.headings, lengths), 1e-3);
}

TEST(InnerProblem, ReportsThatLengthsCannotBeKept) {
  // One edge of a triangle is longer than the sum of the other two edges.
  const Chart chart = test::chart_of(test::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  const WireNetwork network = build_wire_network(chart);
  InnerProblem inner(network, NodeWeight::length);
  Eigen::VectorXd lengths = rest_lengths(network);
  lengths[1] = 5;
  const InnerSolution solution = inner.solve(lengths, Inner::minimum);
  EXPECT_FALSE(solution.is_feasible);
  EXPECT_GT(solution.closure_residual, 0.1);
}

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

/// Returns tan(α/2) of the angle α at a between b and c.
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
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Eigen::Matrix<double, 2, 3> linear = test::random_normal(2, 3, seed);
    const Eigen::Vector2d shift = test::random_normal(2, 1, seed + 10);
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
}  // namespace wirewarp::test_inner_problem
