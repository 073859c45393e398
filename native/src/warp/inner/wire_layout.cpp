// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/wire_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/disjoint_sets.h"

namespace wirewarp {
namespace {

/// Returns, for each vertex, its edges in the minimum spanning tree (Kruskal's algorithm).
std::vector<std::vector<int>> shortest_spanning_tree(const Chart& chart, const WireNetwork& network) {
  std::vector<int> by_length(network.edges.size());
  std::iota(by_length.begin(), by_length.end(), 0);
  std::stable_sort(by_length.begin(), by_length.end(),
                   [&](int a, int b) { return network.edges[a].length < network.edges[b].length; });
  DisjointSets joined(chart.mesh.n_vertices());
  std::vector<std::vector<int>> tree(chart.mesh.n_vertices());
  for (const int e : by_length) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(network.edges[e].edge, 0);
    const int from = chart.mesh.from_vertex_handle(h).idx();
    const int to = chart.mesh.to_vertex_handle(h).idx();
    if (!joined.unite(from, to)) continue;
    tree[from].push_back(e);
    tree[to].push_back(e);
  }
  return tree;
}

}  // namespace

WireLayout::WireLayout(const Chart& chart, const WireNetwork& network) {
  const std::vector<std::vector<int>> tree = shortest_spanning_tree(chart, network);
  const HalfedgeHandle first = chart.mesh.halfedge_handle(network.edges[0].edge, 0);
  root_ = chart.mesh.from_vertex_handle(first).idx();
  std::vector<char> is_placed(chart.mesh.n_vertices(), 0);
  std::vector<int> queue{root_};
  is_placed[root_] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int v = queue[next];
    for (const int e : tree[v]) {
      const HalfedgeHandle h = chart.mesh.halfedge_handle(network.edges[e].edge, 0);
      const int start = chart.mesh.from_vertex_handle(h).idx();
      const int other = start == v ? chart.mesh.to_vertex_handle(h).idx() : start;
      if (is_placed[other]) continue;
      steps_.push_back({e, v, other, start == v ? 1.0 : -1.0});
      is_placed[other] = 1;
      queue.push_back(other);
    }
  }
}

void WireLayout::place(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, Positions2& uv) const {
  uv.row(root_).setZero();
  for (const Step& step : steps_) {
    const Eigen::RowVector2d direction(std::cos(headings[step.edge]), std::sin(headings[step.edge]));
    uv.row(step.to) = uv.row(step.from) + step.sign * lengths[step.edge] * direction;
  }
}

void WireLayout::push_forward(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths,
                              const Eigen::VectorXd& d_headings, const Eigen::VectorXd& d_lengths,
                              Positions2& d_uv) const {
  d_uv.row(root_).setZero();
  for (const Step& step : steps_) {
    const Eigen::RowVector2d direction(std::cos(headings[step.edge]), std::sin(headings[step.edge]));
    const Eigen::RowVector2d normal(-direction[1], direction[0]);
    d_uv.row(step.to) = d_uv.row(step.from) + step.sign * (d_lengths[step.edge] * direction +
                                                           lengths[step.edge] * d_headings[step.edge] * normal);
  }
}

void WireLayout::pull_back(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, const Positions2& by_uv,
                           Eigen::VectorXd& by_headings, Eigen::VectorXd& by_lengths) const {
  by_headings.setZero(headings.size());
  by_lengths.setZero(lengths.size());
  Positions2 beyond = by_uv;  // per vertex: the sum of by_uv over its subtree
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
    const Eigen::RowVector2d force = beyond.row(step->to);
    beyond.row(step->from) += force;
    const Eigen::RowVector2d direction(std::cos(headings[step->edge]), std::sin(headings[step->edge]));
    by_lengths[step->edge] = step->sign * direction.dot(force);
    by_headings[step->edge] = step->sign * lengths[step->edge] * (direction[0] * force[1] - direction[1] * force[0]);
  }
}

}  // namespace wirewarp
