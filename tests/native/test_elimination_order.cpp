// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <optional>
#include <vector>

#include "test_meshes.h"
#include "warp/inner/elimination_order.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_elimination_order {
namespace {

/// A flat rectangle of n by n quads with every `spacing`th line of it a wire, in both directions.
FlattenInput net_of_wires(int n, int spacing) {
  FlattenInput input = test::flat_rectangle(n, n, 1.2, 1);
  for (int line = spacing; line < n; line += spacing) {
    test::add_wire(input, test::grid_row(n, line));
    test::add_wire(input, test::grid_column(n, n, line));
  }
  return input;
}

struct OrderedNetwork {
  explicit OrderedNetwork(const FlattenInput& input)
      : charts(test::charts_of(input)),
        split(process_topology(charts.charts.at(0))),
        network(build_wire_network(split ? *split : charts.charts.at(0))),
        eq1(network, NodeWeight::length),
        order(order_elimination(eq1, network)) {}

  Charts charts;
  std::optional<Chart> split;  // Eq. (1) needs a network in one part
  WireNetwork network;
  Eq1 eq1;
  std::vector<int> order;
};

std::vector<int> places_of(const std::vector<int>& order) {
  std::vector<int> place(order.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) place.at(order[i]) = static_cast<int>(i);
  return place;
}

/// Entries of L below its diagonal when the optimality system is eliminated in this order.
long fill_of(const Eq1& eq1, const std::vector<int>& order) {
  const std::vector<int> place = places_of(order);
  std::vector<std::vector<int>> earlier(order.size());
  const auto couple = [&](int a, int b) {
    const auto [first, last] = std::minmax({place[a], place[b]});
    if (first < last) earlier[last].push_back(first);
  };
  for (int e = 0; e < eq1.num_edges(); ++e) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(eq1.laplacian(), e); it; ++it) {
      couple(e, static_cast<int>(it.row()));
    }
  }
  for (int row = 0; row < eq1.num_closures(); ++row) {
    for (int e : eq1.loop_edges(row / 2)) couple(e, eq1.num_edges() + row);
  }
  std::vector<int> parent(order.size(), -1), seen(order.size(), -1);  // in the elimination tree
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

/// By approximate minimum degree, which does not know that closures come after their edges.
std::vector<int> minimum_degree(const Eq1& eq1) {
  const int size = eq1.num_edges() + eq1.num_closures();
  std::vector<Eigen::Triplet<double>> entries;
  for (int e = 0; e < eq1.num_edges(); ++e) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(eq1.laplacian(), e); it; ++it) {
      entries.emplace_back(static_cast<int>(it.row()), e, 1.0);
    }
  }
  for (int row = 0; row < eq1.num_closures(); ++row) {
    entries.emplace_back(eq1.num_edges() + row, eq1.num_edges() + row, 1.0);
    for (int e : eq1.loop_edges(row / 2)) {
      entries.emplace_back(eq1.num_edges() + row, e, 1.0);
      entries.emplace_back(e, eq1.num_edges() + row, 1.0);
    }
  }
  Eigen::SparseMatrix<double> pattern(size, size);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().begin(), order.indices().end()};
}

std::vector<FlattenInput> networks() {
  return {test::flat_rectangle(4, 3, 1, 1), net_of_wires(12, 1), net_of_wires(20, 4), test::quarter_sphere(8),
          test::flat_plate_with_two_holes(16)};
}

TEST(EliminationOrder, HasEachUnknownOnce) {
  for (const FlattenInput& input : networks()) {
    const OrderedNetwork ordered(input);
    std::vector<int> sorted = ordered.order;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted.size(), static_cast<std::size_t>(ordered.eq1.num_edges() + ordered.eq1.num_closures()));
    for (int i = 0; i < static_cast<int>(sorted.size()); ++i) EXPECT_EQ(sorted[i], i);
  }
}

TEST(EliminationOrder, ClosuresComeAfterTheirEdges) {
  for (const FlattenInput& input : networks()) {
    const OrderedNetwork ordered(input);
    const std::vector<int> place = places_of(ordered.order);
    for (int row = 0; row < ordered.eq1.num_closures(); ++row) {
      for (int e : ordered.eq1.loop_edges(row / 2)) EXPECT_LT(place[e], place[ordered.eq1.num_edges() + row]);
    }
  }
}

/// Minimum degree fills little, and would be taken if it could be: its order puts closures before their edges.
TEST(EliminationOrder, FillsLittleMoreThanMinimumDegreeHoweverDenseTheWires) {
  for (const int spacing : {10, 4, 2}) {
    const OrderedNetwork ordered(net_of_wires(60, spacing));
    const auto least = static_cast<double>(fill_of(ordered.eq1, minimum_degree(ordered.eq1)));
    EXPECT_LT(static_cast<double>(fill_of(ordered.eq1, ordered.order)), 1.6 * least) << spacing;
  }
}

}  // namespace
}  // namespace wirewarp::test_elimination_order
