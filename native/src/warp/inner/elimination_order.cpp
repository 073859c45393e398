// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/elimination_order.h"

#include <array>
#include <utility>

#include "numerics/cholesky/matrix_graph.h"
#include "numerics/cholesky/nested_dissection.h"
#include "surface/mesh/project_to_principal_plane.h"

namespace wirewarp {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using LoopPair = std::array<int, 2>;

int num_loops(const Eq1& eq1) { return eq1.num_closures() / 2; }

/// Returns the loops on both sides of each edge; -1 means no loop.
std::vector<LoopPair> loops_of_edges(const Eq1& eq1) {
  std::vector<LoopPair> loops(eq1.num_edges(), {-1, -1});
  for (int loop = 0; loop < num_loops(eq1); ++loop) {
    for (int e : eq1.loop_edges(loop)) loops[e][loops[e][0] == -1 ? 0 : 1] = loop;
  }
  return loops;
}

/// Connects loops that share an edge, and loops with edges at a common wire-node.
Graph neighbors_of_loops(const Eq1& eq1) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int loop = 0; loop < num_loops(eq1); ++loop) {
    for (int e : eq1.loop_edges(loop)) entries.emplace_back(e, loop, 1.0);
  }
  SparseMatrix on_loops(eq1.num_edges(), num_loops(eq1));
  on_loops.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix neighbors = on_loops.transpose() * SparseMatrix(eq1.laplacian().cwiseAbs() * on_loops);
  return graph_of(neighbors.triangularView<Eigen::Lower>(), 1);
}

Positions2 middles_of_loops(const Eq1& eq1, const WireNetwork& network) {
  Positions3 middles = Positions3::Zero(num_loops(eq1), 3);
  for (int loop = 0; loop < num_loops(eq1); ++loop) {
    const std::vector<int>& edges = eq1.loop_edges(loop);
    for (int e : edges) middles.row(loop) += network.edges[e].middle.transpose();
    middles.row(loop) /= static_cast<double>(edges.size());
  }
  return project_to_principal_plane(middles);
}

}  // namespace

std::vector<int> order_elimination(const Eq1& eq1, const WireNetwork& network) {
  std::vector<int> order;
  std::vector<char> is_ordered(eq1.num_edges(), 0);
  const auto append = [&](int e) {
    if (!std::exchange(is_ordered[e], 1)) order.push_back(e);
  };
  const std::vector<LoopPair> loops = loops_of_edges(eq1);
  // On each line between two crossings of wires, all edges except one come first. Eliminating such an edge fills in
  // only entries for its neighbors and for the loops on its two sides.
  for (int loop = 0; loop < num_loops(eq1); ++loop) {
    const std::vector<int>& edges = eq1.loop_edges(loop);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      const LoopPair& here = loops[edges[i]];
      if (here[0] == loop && here == loops[edges[i + 1]]) append(edges[i]);
    }
  }
  for (const DissectionTree::Node& node :
       nested_dissection(neighbors_of_loops(eq1), middles_of_loops(eq1, network)).nodes) {
    for (int loop : node.vertices) {
      for (int e : eq1.loop_edges(loop)) append(e);
      for (int row : {0, 1}) order.push_back(eq1.num_edges() + 2 * loop + row);
    }
  }
  for (int e = 0; e < eq1.num_edges(); ++e) append(e);  // edges that are on no loop
  return order;
}

}  // namespace wirewarp
