// SPDX-License-Identifier: GPL-3.0-or-later
// The two closures of a slit of one edge depend on each other. The regularization of their pivot was scaled by the mean
// weight of all edges: with tiny edges elsewhere it was lost in rounding, and pieces were "not solvable".
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "processed_chart.h"
#include "test_meshes.h"
#include "warp/inner/kkt_system.h"

namespace wirewarp::slit_of_one_edge_beside_tiny_edges_test {
namespace {

TEST(Bugs, ASlitOfOneEdgeBesideTinyEdgesHasAFactor) {
  const int n = 12;
  for (int i = 0; i < 3 * (n - 2); ++i) {
    const int slit = i / 3, begin = n + 2 + slit;
    const int end = std::array{begin + 1, begin + n + 1, begin + n + 2}[static_cast<std::size_t>(i % 3)];
    const auto graded = [](double s, double t) {  // columns from 1 down to 3^-16
      return Eigen::Vector3d(std::pow(3, -16 * s), t, 0.3 * t * t);
    };
    FlattenInput input = test::make_grid(n, 3, graded);
    test::add_seam(input, {begin, end});  // along an axis, where a closure vanishes, or diagonally
    const Chart chart = test::process(input).refined;
    const WireNetwork network = build_wire_network(chart);
    const Eq1 eq1(network, NodeWeight::length);
    const Eigen::VectorXd psi = Eigen::VectorXd::Zero(eq1.num_edges());
    Eigen::VectorXd lengths(eq1.num_edges());
    for (int e = 0; e < lengths.size(); ++e) lengths[e] = network.edges[e].length;
    KktSystem system(eq1, network);
    EXPECT_TRUE(system.factor(eq1.laplacian(), psi, eq1.closure_jacobian(psi, lengths))) << begin << ' ' << end;
  }
}

}  // namespace
}  // namespace wirewarp::slit_of_one_edge_beside_tiny_edges_test
