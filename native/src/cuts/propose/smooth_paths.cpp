// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/smooth_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "base/planar.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// A landing at δ radians from the outline's bisector adds kPriceOfLanding δ² √area to the cost of a path. At 45°, this
/// is 3% of √area.
constexpr double kPriceOfLanding = 0.05;

/// Largest turn of a path at a vertex, in radians, because darts with corners cannot be sewn. The value is between the
/// turn on regular triangles, 60°, and at a corner of a square, 90°.
constexpr double kSharpTurn = 80 * kPi / 180;

}  // namespace

SmoothPathFinder::SmoothPathFinder(const Chart& chart, Forbidden forbidden)
    : mesh_(chart.mesh),
      size_(std::sqrt(surface_area(chart.mesh))),
      forbidden_(std::move(forbidden)),
      direction_(chart.mesh.n_halfedges(), 0),
      full_turn_(chart.mesh.n_vertices(), 0) {
  for (const VertexHandle v : mesh_.vertices()) {
    // At a vertex of the outline, halfedge_handle() returns the half-edge without a face. Counterclockwise, this
    // half-edge is the last at the vertex.
    const HalfedgeHandle last = mesh_.halfedge_handle(v);
    const bool is_on_outline = mesh_.is_boundary(v);
    const HalfedgeHandle first =
        is_on_outline ? mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(last)) : last;
    HalfedgeHandle h = first;
    double& angle = full_turn_[v.idx()];
    do {
      direction_[h.idx()] = angle;
      if (mesh_.is_boundary(h)) break;
      angle += corner_angle(mesh_, h);
      h = next_counterclockwise(mesh_, h);
    } while (h != first);
  }
}

double SmoothPathFinder::landing_cost(HalfedgeHandle leaving) const {
  const double from_bisector = direction_[leaving.idx()] - full_turn_[mesh_.from_vertex_handle(leaving).idx()] / 2;
  return kPriceOfLanding * size_ * from_bisector * from_bisector;
}

double SmoothPathFinder::turn(HalfedgeHandle in, HalfedgeHandle out) const {
  const double full = full_turn_[mesh_.from_vertex_handle(out).idx()];
  double left = direction_[mesh_.opposite_halfedge_handle(in).idx()] - direction_[out.idx()];
  if (left < 0) left += full;
  return kPi - left * 2 * kPi / full;
}

SmoothPaths SmoothPathFinder::paths_from(VertexHandle start) const {
  using Entry = std::pair<double, int>;  // cost, half-edge
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SmoothPaths paths{std::vector<double>(mesh_.n_halfedges(), kInfinity),
                    std::vector<HalfedgeHandle>(mesh_.n_halfedges()), std::vector<HalfedgeHandle>(mesh_.n_vertices())};
  std::vector<double> least(mesh_.n_vertices(), kInfinity);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](HalfedgeHandle h, HalfedgeHandle before, double cost) {
    const VertexHandle to = mesh_.to_vertex_handle(h);
    const EdgeHandle edge = mesh_.edge_handle(h);
    if (is_forbidden(to) || is_forbidden(edge) || mesh_.is_boundary(edge) || to == start) return;
    if (mesh_.is_boundary(to)) cost += landing_cost(mesh_.opposite_halfedge_handle(h));
    if (cost >= paths.cost[h.idx()]) return;
    paths.cost[h.idx()] = cost;
    paths.before[h.idx()] = before;
    queue.emplace(cost, h.idx());
  };
  for (const HalfedgeHandle h : mesh_.voh_range(start)) {
    reach(h, HalfedgeHandle(), edge_length(mesh_, h) + (mesh_.is_boundary(start) ? landing_cost(h) : 0));
  }
  while (!queue.empty()) {
    const auto [cost, index] = queue.top();
    queue.pop();
    const HalfedgeHandle h(index);
    if (cost > paths.cost[index]) continue;
    const VertexHandle v = mesh_.to_vertex_handle(h);
    if (cost < least[v.idx()]) {
      least[v.idx()] = cost;
      paths.arrival[v.idx()] = h;
    }
    if (mesh_.is_boundary(v)) continue;
    for (const HalfedgeHandle out : mesh_.voh_range(v)) {
      if (out == mesh_.opposite_halfedge_handle(h)) continue;
      const double angle = turn(h, out);
      if (std::abs(angle) > kSharpTurn) continue;
      const double length = edge_length(mesh_, out);
      reach(out, h, cost + length + angle * angle * (length + edge_length(mesh_, h)) / 2);
    }
  }
  return paths;
}

HalfEdgeChain SmoothPathFinder::path_to(const SmoothPaths& paths, VertexHandle end) const {
  HalfEdgeChain path;
  for (HalfedgeHandle h = paths.arrival[end.idx()]; h.is_valid(); h = paths.before[h.idx()]) path.push_back(h);
  std::reverse(path.begin(), path.end());
  // The cheapest path to a half-edge may contain a loop, because sharp turns are forbidden. Such a path is refused,
  // because a cut along the loop would cut out a separate part.
  std::vector<VertexHandle> passed;
  for (const HalfedgeHandle h : path) passed.push_back(mesh_.to_vertex_handle(h));
  std::sort(passed.begin(), passed.end());
  if (std::adjacent_find(passed.begin(), passed.end()) != passed.end()) return {};
  return path;
}

}  // namespace wirewarp
