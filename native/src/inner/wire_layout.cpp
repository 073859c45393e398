// SPDX-License-Identifier: GPL-3.0-or-later
#include "inner/wire_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "index.h"

namespace wirewarp {
namespace {

/// Kruskal's minimum spanning tree: for each vertex its tree edges.
std::vector<std::vector<int>> shortest_spanning_tree(const Chart& chart, const WireNetwork& network) {
  std::vector<int> by_length(network.edges.size());
  std::iota(by_length.begin(), by_length.end(), 0);
  std::stable_sort(by_length.begin(), by_length.end(),
                   [&](int a, int b) { return network.edges[at(a)].length < network.edges[at(b)].length; });
  std::vector<int> parent(chart.mesh.n_vertices());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root_of = [&](int v) {
    while (parent[at(v)] != v) v = parent[at(v)] = parent[at(parent[at(v)])];
    return v;
  };
  std::vector<std::vector<int>> tree(chart.mesh.n_vertices());
  for (int e : by_length) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(network.edges[at(e)].edge, 0);
    const int from = chart.mesh.from_vertex_handle(h).idx();
    const int to = chart.mesh.to_vertex_handle(h).idx();
    if (root_of(from) == root_of(to)) continue;
    parent[at(root_of(from))] = root_of(to);
    tree[at(from)].push_back(e);
    tree[at(to)].push_back(e);
  }
  return tree;
}

}  // namespace

void lay_out_wires(const Chart& chart, const WireNetwork& network, const Eigen::VectorXd& headings,
                   const Eigen::VectorXd& lengths, Positions2& uv) {
  const std::vector<std::vector<int>> tree = shortest_spanning_tree(chart, network);
  const HalfedgeHandle first = chart.mesh.halfedge_handle(network.edges[0].edge, 0);
  const int root = chart.mesh.from_vertex_handle(first).idx();
  std::vector<char> is_placed(chart.mesh.n_vertices(), 0);
  std::vector<int> queue{root};
  is_placed[at(root)] = 1;
  uv.row(root).setZero();
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int v = queue[next];
    for (int e : tree[at(v)]) {
      const HalfedgeHandle h = chart.mesh.halfedge_handle(network.edges[at(e)].edge, 0);
      const int from = chart.mesh.from_vertex_handle(h).idx();
      const int other = from == v ? chart.mesh.to_vertex_handle(h).idx() : from;
      if (is_placed[at(other)]) continue;
      const double along = from == v ? lengths[e] : -lengths[e];
      uv.row(other) = uv.row(v) + along * Eigen::RowVector2d(std::cos(headings[e]), std::sin(headings[e]));
      is_placed[at(other)] = 1;
      queue.push_back(other);
    }
  }
}

}  // namespace wirewarp
