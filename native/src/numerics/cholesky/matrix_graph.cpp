// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/matrix_graph.h"

namespace wirewarp {

Graph graph_of(const Eigen::SparseMatrix<double>& lower, int unknowns_per_vertex) {
  const auto num_vertices = static_cast<std::size_t>(lower.cols() / unknowns_per_vertex);
  const auto for_each_pair = [&](const auto& visit) {
    for (std::size_t v = 0; v < num_vertices; ++v) {
      const int column = unknowns_per_vertex * static_cast<int>(v);
      for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it) {
        const int row = static_cast<int>(it.row());
        if (row >= column + unknowns_per_vertex && row % unknowns_per_vertex == 0) {
          visit(v, (row / unknowns_per_vertex));
        }
      }
    }
  };
  Graph graph;
  graph.start.assign(num_vertices + 1, 0);
  for_each_pair([&](std::size_t a, std::size_t b) { ++graph.start[a + 1], ++graph.start[b + 1]; });
  for (std::size_t v = 0; v < num_vertices; ++v) graph.start[v + 1] += graph.start[v];
  graph.neighbors.resize(graph.start.back());
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  for_each_pair([&](std::size_t a, std::size_t b) {
    graph.neighbors[next[a]++] = static_cast<int>(b);
    graph.neighbors[next[b]++] = static_cast<int>(a);
  });
  return graph;
}

}  // namespace wirewarp
