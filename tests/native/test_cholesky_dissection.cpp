// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <random>
#include <utility>
#include <vector>

#include "cholesky_problems.h"
#include "numerics/cholesky/vertex_separator.h"

namespace wirewarp::test_cholesky_dissection {
namespace {

std::size_t index_of(int i) { return static_cast<std::size_t>(i); }

/// The node of each vertex; checks that there is one, and that nodes come after their descendants without a gap.
std::vector<int> node_of_vertices(const DissectionTree& tree, int num_vertices) {
  std::vector<int> node_of(index_of(num_vertices), -1);
  std::vector<int> first(tree.nodes.size());
  for (int node = 0; node < static_cast<int>(tree.nodes.size()); ++node) first[index_of(node)] = node;
  for (int node = 0; node < static_cast<int>(tree.nodes.size()); ++node) {
    const DissectionTree::Node& here = tree.nodes[index_of(node)];
    EXPECT_FALSE(here.vertices.empty());
    for (int v : here.vertices) {
      EXPECT_EQ(std::exchange(node_of.at(index_of(v)), node), -1) << "vertex " << v << " is in two nodes";
    }
    if (here.parent == -1) continue;
    EXPECT_GT(here.parent, node);
    first.at(index_of(here.parent)) = std::min(first.at(index_of(here.parent)), first[index_of(node)]);
  }
  for (std::size_t node = 0; node < tree.nodes.size(); ++node) {  // all between a subtree's ends are in it
    for (int below = first[node]; below < static_cast<int>(node); ++below) {
      int ancestor = below;
      while (ancestor != -1 && ancestor < static_cast<int>(node)) ancestor = tree.nodes[index_of(ancestor)].parent;
      EXPECT_EQ(ancestor, static_cast<int>(node));
    }
  }
  EXPECT_EQ(std::count(node_of.begin(), node_of.end(), -1), 0);
  return node_of;
}

TEST(NestedDissection, SeparatesEveryGraph) {
  for (const CholeskyProblem& problem : cholesky_problems()) {
    SCOPED_TRACE(problem.name);
    const DissectionTree tree = problem.tree();
    const std::vector<int> node_of = node_of_vertices(tree, static_cast<int>(problem.positions.rows()));
    for (const auto& [a, b] : problem.edges) {
      const auto [earlier, later] = std::minmax({node_of[index_of(a)], node_of[index_of(b)]});
      int ancestor = earlier;
      while (ancestor != -1 && ancestor < later) ancestor = tree.nodes[index_of(ancestor)].parent;
      EXPECT_EQ(ancestor, later) << "edge " << a << " " << b;
    }
  }
}

/// A row of a square of n by n vertices separates it, though the median by the jittered coordinates is no straight
/// line.
TEST(NestedDissection, SeparatorOfASquareIsAboutARowOfIt) {
  for (const int n : {20, 50, 100}) {
    const DissectionTree tree = mesh_problem(n, 1).tree();
    EXPECT_EQ(tree.nodes.back().parent, -1);
    EXPECT_LE(tree.nodes.back().vertices.size(), index_of(n + n / 10)) << n;
    const auto halves = std::count_if(tree.nodes.begin(), tree.nodes.end(), [&](const DissectionTree::Node& node) {
      return node.parent == static_cast<int>(tree.nodes.size()) - 1;
    });
    EXPECT_EQ(halves, 2);
  }
}

TEST(NestedDissection, LeavesAreSmall) {
  const DissectionTree tree = mesh_problem(50, 1).tree();
  std::vector<char> is_leaf(tree.nodes.size(), 1);
  for (const DissectionTree::Node& node : tree.nodes) {
    if (node.parent != -1) is_leaf[index_of(node.parent)] = 0;
  }
  for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
    if (!is_leaf[node]) continue;
    EXPECT_LE(tree.nodes[node].vertices.size(), 16u);
  }
}

TEST(NestedDissection, ChoosesTheShortWayAcross) {
  // A strip of 4 by 100 vertices along a diagonal: neither x nor y alone cuts it across.
  GraphEdges edges;
  Positions2 positions(400, 2);
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 4; ++j) {
      positions.row(4 * i + j) << i - j, i + j;
      if (j < 3) edges.push_back({4 * i + j, 4 * i + j + 1});
      if (i < 99) edges.push_back({4 * i + j, 4 * i + j + 4});
    }
  }
  const DissectionTree tree = nested_dissection(graph_of(400, edges), positions);
  EXPECT_EQ(tree.nodes.back().vertices.size(), 4u);
}

TEST(NestedDissection, PiecesShareNoSeparator) {
  // Two rows of vertices, each joined along itself only, one upon the other.
  GraphEdges edges;
  Positions2 positions(80, 2);
  for (int i = 0; i < 80; ++i) {
    positions.row(i) << i % 40, 0;
    if (i % 40 != 0) edges.push_back({i - 1, i});
  }
  const DissectionTree tree = nested_dissection(graph_of(80, edges), positions);
  const auto roots = std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                   [](const DissectionTree::Node& node) { return node.parent == -1; });
  EXPECT_EQ(roots, 2);
  for (const DissectionTree::Node& node : tree.nodes) {
    if (node.parent != -1) continue;
    EXPECT_EQ(node.vertices.size(), 1u);
  }
}

TEST(VertexSeparator, IsTheSmallest) {
  constexpr int kHalf = 6;
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    GraphEdges edges;
    for (int a = 0; a < kHalf; ++a) {
      for (int b = 0; b < kHalf; ++b) {
        if (random() % 10 < 1 + static_cast<unsigned>(trial) % 4) edges.push_back({a, kHalf + b});
      }
    }
    const auto covers_all = [&](unsigned subset) {
      return std::all_of(edges.begin(), edges.end(),
                         [&](const auto& edge) { return (subset >> edge[0] | subset >> edge[1]) & 1u; });
    };
    std::size_t fewest = 2 * kHalf;
    for (unsigned subset = 0; subset < 1u << (2 * kHalf); ++subset) {
      if (covers_all(subset)) fewest = std::min(fewest, std::bitset<2 * kHalf>(subset).count());
    }
    std::vector<Side> side(2 * kHalf, Side::outside);
    std::vector<int> cut;
    for (const auto& [a, b] : edges) {
      side[index_of(a)] = Side::lower_cut;
      side[index_of(b)] = Side::upper_cut;
    }
    for (int v = 0; v < 2 * kHalf; ++v) {
      if (side[index_of(v)] != Side::outside) cut.push_back(v);
    }
    const Graph graph = graph_of(2 * kHalf, edges);
    VertexSeparator(graph).separate(cut, side);
    unsigned separator = 0;
    for (int v = 0; v < 2 * kHalf; ++v) separator |= (side[index_of(v)] == Side::separator ? 1u : 0u) << v;
    EXPECT_TRUE(covers_all(separator));
    EXPECT_EQ(std::bitset<2 * kHalf>(separator).count(), fewest);
  }
}

TEST(NestedDissection, EmptyGraph) { EXPECT_TRUE(nested_dissection({{0}, {}}, Positions2(0, 2)).nodes.empty()); }

}  // namespace
}  // namespace wirewarp::test_cholesky_dissection
