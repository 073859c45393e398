// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/shortest_paths.h"

#include <cmath>
#include <limits>
#include <queue>

#include "surface/mesh/geometry.h"

namespace wirewarp {

ShortestPaths shortest_paths(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& sources,
                             const PathRules& rules) {
  using Entry = std::pair<double, int>;  // distance, vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  ShortestPaths paths{std::vector<double>(mesh.n_vertices(), std::numeric_limits<double>::infinity()),
                      std::vector<HalfedgeHandle>(mesh.n_vertices()), VertexHandle()};
  for (const VertexHandle v : sources) {
    paths.distance[v.idx()] = 0;
    queue.emplace(0.0, v.idx());
  }
  while (!queue.empty()) {
    const auto [reached, index] = queue.top();
    queue.pop();
    if (reached > paths.distance[index]) continue;
    if (rules.ends_at && rules.ends_at(VertexHandle(index))) {
      paths.end = VertexHandle(index);
      break;
    }
    for (const HalfedgeHandle h : mesh.voh_range(VertexHandle(index))) {
      const int next = mesh.to_vertex_handle(h).idx();
      const double length = reached + edge_length(mesh, h);
      if (length >= paths.distance[next] || (rules.may_follow && !rules.may_follow(h))) continue;
      paths.distance[next] = length;
      paths.arrival[next] = h;
      queue.emplace(length, next);
    }
  }
  return paths;
}

std::vector<HalfedgeHandle> path_back(const HalfEdgeMesh& mesh, const ShortestPaths& paths, VertexHandle v) {
  std::vector<HalfedgeHandle> path;
  for (HalfedgeHandle h = paths.arrival[v.idx()]; h.is_valid(); h = paths.arrival[mesh.from_vertex_handle(h).idx()]) {
    path.push_back(h);
  }
  return path;
}

VertexHandle farthest_vertex(const ShortestPaths& paths) {
  // A path counts as longer only if it is longer by this factor, because smaller differences may be rounding errors,
  // which depend on the model's orientation.
  constexpr double kClearly = 1 + 1e-9;
  int farthest = 0;
  for (int v = 1; v < static_cast<int>(paths.distance.size()); ++v) {
    const double distance = paths.distance[v];
    if (std::isfinite(distance) && distance > kClearly * paths.distance[farthest]) farthest = v;
  }
  return VertexHandle(farthest);
}

std::vector<VertexHandle> boundary_vertices(const HalfEdgeMesh& mesh) {
  std::vector<VertexHandle> boundary;
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_boundary(v)) boundary.push_back(v);
  }
  return boundary;
}

}  // namespace wirewarp
