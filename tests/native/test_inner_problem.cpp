// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "test_meshes.h"
#include "warp/inner/inner_problem.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_inner_problem {
namespace {

Eigen::VectorXd rest_lengths(const WireNetwork& network) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(network.edges.size()));
  for (Eigen::Index e = 0; e < lengths.size(); ++e) lengths[e] = network.edges[static_cast<std::size_t>(e)].length;
  return lengths;
}

/// Returns the objective of Eq. (1).
double angle_variation(const WireNetwork& network, const InnerSolution& solution) {
  return Eq1(network, NodeWeight::length).angle_variation(solution.psi);
}

/// Returns the largest gap of these loops with the given headings, relative to the loop's length.
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
  for (int v = 0; v < input.vertices.rows(); ++v) {
    const double x = input.vertices(v, 0) - 1.5;
    const double y = input.vertices(v, 1) - 1;
    input.vertices(v, 2) = 0.5 * std::exp(-x * x - y * y);
  }
  return input;
}

TEST(InnerProblem, EndsAtMinimaNotAtSaddles) {
  // Patches of the sphere with wires on their axes of symmetry have many stationary points. At the result, the Hessian
  // of the Lagrangian must be positive definite on the null space of the closures.
  for (const double height : {0.8, 1.2, 1.6}) {
    for (const int n : {2, 4, 8}) {
      FlattenInput input = test::make_grid(n, 2 * n, [&](double s, double t) {
        const double longitude = 0.8 * (2 * s - 1);
        const double latitude = height * 0.75 * (2 * t - 1);
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
  // To close these tubes, edges turn so far that the linearized gap is wrong.
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
  // A square tube. The change of headings that lowers Eq. (1) is almost orthogonal to the symmetry_breaker of Eq1, with
  // which the search for this change starts.
  const FlattenInput tube = test::make_tube(20, 2, [](double s, double t) {
    const int side = static_cast<int>(std::floor(4 * s + 1e-9)) % 4;
    const double along = 4 * s - side;
    const double x[] = {along, 1, 1 - along, 0}, y[] = {0, along, 1, 1 - along};
    return Eigen::Vector3d(x[side], y[side], 0.4 * t);
  });
  const std::optional<Chart> chart = process_topology(test::charts_of(tube).charts[0]);
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
  EXPECT_LT(angle_variation(network, minimum), angle_variation(network, feasible) * (1 - 1e-6));
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

}  // namespace
}  // namespace wirewarp::test_inner_problem
