// SPDX-License-Identifier: GPL-3.0-or-later
// Tests Eq. (1) as a function of edge headings, and the linear system of its minimum.
#include <gtest/gtest.h>

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "dense_algebra.h"
#include "test_meshes.h"
#include "warp/inner/elimination_order.h"
#include "warp/inner/eq1.h"
#include "warp/inner/kkt_system.h"
#include "warp/inner/linear_angle_constraints.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_eq1 {
namespace {

FlattenInput bent_plate() {
  FlattenInput input = test::flat_plate_with_wires(4);
  for (auto p : input.vertices.rowwise()) p[2] = 0.3 * std::sin(1.3 * p[0]) * std::cos(1.1 * p[1]) + 0.1 * p[0] * p[1];
  return input;
}

struct Problem {
  explicit Problem(NodeWeight weight)
      : network(build_wire_network(test::chart_of(bent_plate()))), eq1(network, weight) {
    lengths.resize(eq1.num_edges());
    for (int e = 0; e < eq1.num_edges(); ++e) lengths[e] = network.edges[e].length;
    psi = 0.3 * test::random_normal(eq1.num_edges(), 1, 7);
    direction = 0.3 * test::random_normal(eq1.num_edges(), 1, 8);
    multipliers = 0.3 * test::random_normal(eq1.num_closures(), 1, 9);
  }
  /// Returns the weights of the wire nodes: 1, or the mean length of all nodes over the node's length.
  Eigen::VectorXd node_weights(NodeWeight weight) const {
    Eigen::VectorXd lengths_of_nodes(network.nodes.size());
    for (Eigen::Index i = 0; i < lengths_of_nodes.size(); ++i) {
      lengths_of_nodes[i] = weight == NodeWeight::length ? network.nodes[i].length : 1;
    }
    return lengths_of_nodes.mean() * lengths_of_nodes.cwiseInverse();
  }
  /// Returns the planar angles θ for the headings psi. If psi is 0, they are the angles with the required sums that are
  /// closest to the surface angles.
  Eigen::VectorXd planar_angles(NodeWeight weight) const {
    Eigen::VectorXd angles = project_on_angle_sums(network, node_weights(weight));
    for (Eigen::Index i = 0; i < angles.size(); ++i) {
      const WireNode& node = network.nodes[i];
      angles[i] -= psi[node.out.edge] - psi[node.in.edge];
    }
    return angles;
  }
  WireNetwork network;
  Eq1 eq1;
  Eigen::VectorXd lengths, psi, direction, multipliers;
};

class Eq1Test : public testing::TestWithParam<NodeWeight> {};
INSTANTIATE_TEST_SUITE_P(Weights, Eq1Test, testing::Values(NodeWeight::length, NodeWeight::uniform));

constexpr double kStep = 1e-5;

TEST_P(Eq1Test, PlanarAnglesHaveTheRequiredSumsForAllHeadings) {
  const Problem p(GetParam());
  const Eigen::VectorXd angles = p.planar_angles(GetParam());
  for (const WirePatch& patch : p.network.patches) {
    double turning = 0;
    for (const WirePatch::Step& step : patch.loops[0]) turning += kPi - angles[step.node];
    EXPECT_NEAR(turning, 2 * kPi, 1e-12);
  }
  ASSERT_FALSE(p.network.inner_vertex_nodes.empty());
  for (const std::vector<int>& nodes : p.network.inner_vertex_nodes) {
    double sum = 0;
    for (int node : nodes) sum += angles[node];
    EXPECT_NEAR(sum, 2 * kPi, 1e-12);
  }
}

TEST_P(Eq1Test, IsTheWeightedSumOfSquaredAngleDeviations) {
  const Problem p(GetParam());
  const Eigen::VectorXd angles = p.planar_angles(GetParam()), weights = p.node_weights(GetParam());
  double expected = 0;
  for (Eigen::Index i = 0; i < angles.size(); ++i) {
    const double deviation = angles[i] - p.network.nodes[i].surface_angle;
    expected += weights[i] * deviation * deviation / 2;
  }
  EXPECT_NEAR(p.eq1.angle_variation(p.psi), expected, 1e-12 * expected);
}

TEST_P(Eq1Test, HeadingsTurnByThePlanarAngles) {
  const Problem p(GetParam());
  const Eigen::VectorXd angles = p.planar_angles(GetParam());
  const Eigen::VectorXd headings = p.eq1.headings(p.psi);
  const auto heading = [&](WireHalfEdge h) { return headings[h.edge] + (h.reversed ? kPi : 0); };
  for (Eigen::Index i = 0; i < angles.size(); ++i) {
    const WireNode& node = p.network.nodes[i];
    EXPECT_NEAR(std::remainder(heading(node.out) - heading(node.in) - (kPi - angles[i]), 2 * kPi), 0, 1e-12);
  }
}

TEST_P(Eq1Test, GradientAgreesWithDifferences) {
  const Problem p(GetParam());
  const double difference =
      (p.eq1.angle_variation(p.psi + kStep * p.direction) - p.eq1.angle_variation(p.psi - kStep * p.direction)) /
      (2 * kStep);
  EXPECT_NEAR(p.eq1.gradient(p.psi).dot(p.direction), difference, 1e-8 * std::abs(difference));
}

TEST_P(Eq1Test, LaplacianIsTheDerivativeOfTheGradient) {
  const Problem p(GetParam());
  const Eigen::VectorXd difference = p.eq1.gradient(p.psi + p.direction) - p.eq1.gradient(p.psi);
  EXPECT_LT((p.eq1.laplacian() * p.direction - difference).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST_P(Eq1Test, ClosureJacobianAgreesWithDifferences) {
  const Problem p(GetParam());
  const Eigen::VectorXd difference =
      (p.eq1.closure(p.psi + kStep * p.direction, p.lengths) - p.eq1.closure(p.psi - kStep * p.direction, p.lengths)) /
      (2 * kStep);
  const Eigen::VectorXd derivative = p.eq1.closure_jacobian(p.psi, p.lengths) * p.direction;
  EXPECT_LT((derivative - difference).norm(), 1e-8 * difference.norm());
}

TEST_P(Eq1Test, HessianOfTheLagrangianAgreesWithDifferences) {
  const Problem p(GetParam());
  const auto lagrangian_gradient = [&](const Eigen::VectorXd& psi) -> Eigen::VectorXd {
    return p.eq1.gradient(psi) + p.eq1.closure_jacobian(psi, p.lengths).transpose() * p.multipliers;
  };
  const Eigen::VectorXd difference =
      (lagrangian_gradient(p.psi + kStep * p.direction) - lagrangian_gradient(p.psi - kStep * p.direction)) /
      (2 * kStep);
  const Eigen::VectorXd hessian = p.eq1.laplacian() * p.direction +
                                  p.eq1.closure_hessian(p.psi, p.lengths, p.multipliers).cwiseProduct(p.direction);
  EXPECT_LT((hessian - difference).norm(), 1e-8 * difference.norm());
}

TEST(KktSystem, SolvesTheOptimalitySystem) {
  const Problem p(NodeWeight::length);
  KktSystem kkt(p.eq1, p.network);
  const Eigen::SparseMatrix<double> jacobian = p.eq1.closure_jacobian(p.psi, p.lengths);
  ASSERT_TRUE(kkt.factor(p.eq1.laplacian(), Eigen::VectorXd::Zero(p.eq1.num_edges()), jacobian));
  // These right-hand sides do not rotate the whole piece, so the extra diagonal entry of one edge has no effect.
  const Eigen::VectorXd r1 = p.eq1.laplacian() * p.direction;
  const Eigen::VectorXd r2 = jacobian * p.direction;
  const KktSystem::Solution solution = kkt.solve(r1, r2);
  EXPECT_LT((jacobian * solution.step - r2).lpNorm<Eigen::Infinity>(), 1e-12);
  const Eigen::VectorXd residual = p.eq1.laplacian() * solution.step + jacobian.transpose() * solution.multipliers - r1;
  EXPECT_LT(residual.tail(residual.size() - 1).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(KktSystem, RefusesTheWrongInertia) {
  const Problem p(NodeWeight::length);
  KktSystem kkt(p.eq1, p.network);
  const Eigen::SparseMatrix<double> jacobian = p.eq1.closure_jacobian(p.psi, p.lengths);
  const Eigen::VectorXd down = Eigen::VectorXd::Constant(p.eq1.num_edges(), -0.5 * p.eq1.laplacian().diagonal().mean());
  EXPECT_FALSE(kkt.factor(p.eq1.laplacian(), down, jacobian))
      << "a saddle, because slowly varying rotations of edges lower the energy";
}

TEST(Eq1, EdgesMustBeConnected) {
  const Chart chart = test::chart_of(test::flat_plate_with_two_holes(2));  // three loops, no wires
  EXPECT_THROW(Eq1(build_wire_network(chart), NodeWeight::length), std::domain_error);
}

FlattenInput net_of_wires(int n, int spacing) {
  FlattenInput input = test::flat_rectangle(n, n, 1.2, 1);
  for (int line = spacing; line < n; line += spacing) test::add_net(input, n, {line});
  return input;
}

struct OrderedNetwork {
  explicit OrderedNetwork(const FlattenInput& input)
      : whole(test::chart_of(input)),
        network(build_wire_network(process_topology(whole).value_or(whole))),
        eq1(network, NodeWeight::length),
        order(order_elimination(eq1, network)) {}

  Chart whole;
  WireNetwork network;  // with helper wires, because Eq. (1) needs a connected network
  Eq1 eq1;
  std::vector<int> order;
};

std::vector<int> places_of(const std::vector<int>& order) {
  std::vector<int> place(order.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) place.at(order[i]) = static_cast<int>(i);
  return place;
}

/// Returns the pairs of coupled unknowns of the optimality system. Its unknowns are first the edges, then the closures.
std::vector<std::pair<int, int>> couplings(const Eq1& eq1) {
  std::vector<std::pair<int, int>> pairs;
  for (int e = 0; e < eq1.num_edges(); ++e) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(eq1.laplacian(), e); it; ++it) {
      pairs.emplace_back(static_cast<int>(it.row()), e);
    }
  }
  for (int row = 0; row < eq1.num_closures(); ++row) {
    for (int e : eq1.loop_edges(row / 2)) pairs.emplace_back(e, eq1.num_edges() + row);
  }
  return pairs;
}

/// Returns the number of entries of the factor L below its diagonal if the optimality system is eliminated in this
/// order.
long fill_of(const Eq1& eq1, const std::vector<int>& order) {
  const std::vector<int> place = places_of(order);
  std::vector<std::vector<int>> earlier(order.size());
  for (const auto& [a, b] : couplings(eq1)) {
    const auto [first, last] = std::minmax({place[a], place[b]});
    if (first < last) earlier[last].push_back(first);
  }
  std::vector<int> parent(order.size(), -1), seen(order.size(), -1);  // parents in the elimination tree
  long fill = 0;
  for (int k = 0; k < static_cast<int>(order.size()); ++k) {
    seen[k] = k;
    for (int i : earlier[k]) {
      for (; seen[i] != k; i = parent[i]) {
        seen[i] = k;
        ++fill;
        if (parent[i] == -1) parent[i] = k;
      }
    }
  }
  return fill;
}

std::vector<int> minimum_degree(const Eq1& eq1) {
  const int size = eq1.num_edges() + eq1.num_closures();
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 1.0);
  for (const auto& [a, b] : couplings(eq1)) {
    entries.emplace_back(a, b, 1.0);
    entries.emplace_back(b, a, 1.0);
  }
  Eigen::SparseMatrix<double> pattern(size, size);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().begin(), order.indices().end()};
}

TEST(EliminationOrder, ClosuresComeAfterTheirEdges) {
  for (const FlattenInput& input : {test::flat_rectangle(4, 3, 1, 1), net_of_wires(12, 1), net_of_wires(20, 4),
                                    test::quarter_sphere(8), test::flat_plate_with_two_holes(16)}) {
    const OrderedNetwork ordered(input);
    const std::vector<int> place = places_of(ordered.order);
    for (int row = 0; row < ordered.eq1.num_closures(); ++row) {
      for (int e : ordered.eq1.loop_edges(row / 2)) EXPECT_LT(place[e], place[ordered.eq1.num_edges() + row]);
    }
  }
}

/// The minimum degree order has little fill, but cannot be used, because it eliminates closures before their edges.
TEST(EliminationOrder, FillsLittleMoreThanMinimumDegreeHoweverDenseTheWires) {
  for (const int spacing : {10, 2}) {
    const OrderedNetwork ordered(net_of_wires(60, spacing));
    const auto least = static_cast<double>(fill_of(ordered.eq1, minimum_degree(ordered.eq1)));
    EXPECT_LT(static_cast<double>(fill_of(ordered.eq1, ordered.order)), 1.6 * least) << spacing;
  }
}

}  // namespace
}  // namespace wirewarp::test_eq1
