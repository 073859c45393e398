// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/cut_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mesh/geometry.h"
#include "mesh/shortest_paths.h"
#include "planar.h"

namespace wirewarp {
namespace {

constexpr int kMostEnds = 24;         // about a fifth of the piece's width apart
constexpr double kWindow = 1.0 / 24;  // of the outline to each side: where a way is the shortest of its neighborhood
constexpr double kCorner = kPi / 6;   // turn of the outline, radians

constexpr double kApart = 0.15;  // of ends that are not beside each other, over the root of the area

struct OutlinePoint {
  VertexHandle vertex;
  double at = 0;  // length of the loop up to it
  bool is_corner = false;
};

using OutlineLoop = std::vector<OutlinePoint>;

OutlineLoop measure_loop(const Chart& chart, const HalfEdgeChain& half_edges) {
  OutlineLoop loop;
  double at = 0;
  for (std::size_t i = 0; i < half_edges.size(); ++i) {
    const HalfedgeHandle h = half_edges[i];
    double angle = 0;  // inside
    for (HalfedgeHandle around = h; !chart.mesh.is_boundary(around); around = next_counterclockwise(chart.mesh, around))
      angle += corner_angle(chart.mesh, around);
    loop.push_back({chart.mesh.from_vertex_handle(h), at, std::abs(angle - kPi) > kCorner});
    at += edge_length(chart.mesh, h);
  }
  return loop;
}

/// Where the paths to a loop are shorter than to all points of it near by, and its corners.
void take_landings(const OutlineLoop& loop, double length, const SmoothPaths& paths, std::vector<VertexHandle>& taken) {
  const auto cost_at = [&](std::size_t i) {
    const HalfedgeHandle h = paths.arrival[loop[i].vertex.idx()];
    return h.is_valid() ? paths.cost[h.idx()] : std::numeric_limits<double>::infinity();
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double cost = cost_at(i);
    if (!std::isfinite(cost)) continue;
    bool is_least = true;
    for (std::size_t j = 0; j < loop.size() && is_least; ++j) {
      const double apart = std::abs(loop[i].at - loop[j].at);
      if (i == j || std::min(apart, length - apart) > kWindow * length) continue;
      is_least = cost < cost_at(j) || (cost == cost_at(j) && i < j);
    }
    if (is_least || loop[i].is_corner) taken.push_back(loop[i].vertex);
  }
}

/// So many vertices at most, each as far as can be from the sources and those before.
std::vector<VertexHandle> spread(const Chart& chart, std::vector<VertexHandle> sources,
                                 const std::vector<char>& may_take, int count) {
  std::vector<VertexHandle> taken;
  while (static_cast<int>(taken.size()) < count) {
    const ShortestPaths paths = shortest_paths(chart.mesh, sources);
    int farthest = -1;
    for (int v = 0; v < static_cast<int>(may_take.size()); ++v) {
      if (may_take[v] != 0 && paths.distance[v] > 0 && (farthest < 0 || paths.distance[v] > paths.distance[farthest]))
        farthest = v;
    }
    if (farthest < 0) break;
    taken.push_back(VertexHandle(farthest));
    sources.push_back(VertexHandle(farthest));
  }
  return taken;
}

}  // namespace

std::vector<CutEnds> list_candidates(const Chart& chart, const SmoothPathFinder& paths, CutKind kind) {
  std::vector<OutlineLoop> loops;
  for (const HalfEdgeChain& loop : chart.boundary_loops) loops.push_back(measure_loop(chart, loop));
  std::vector<char> may_take(chart.mesh.n_vertices(), 0);
  for (const VertexHandle v : chart.mesh.vertices()) {
    may_take[v.idx()] = chart.mesh.is_boundary(v) == (kind == CutKind::seam) && !paths.is_barred(v) ? 1 : 0;
  }
  std::vector<VertexHandle> sources = boundary_vertices(chart.mesh);
  if (kind == CutKind::seam) {  // from the corners on
    sources.clear();
    for (const OutlineLoop& loop : loops) {
      for (const OutlinePoint& point : loop) {
        if (point.is_corner && !paths.is_barred(point.vertex)) sources.push_back(point.vertex);
      }
    }
    if (sources.empty()) sources.push_back(loops.front().front().vertex);
  }
  std::vector<VertexHandle> ends = spread(chart, sources, may_take, kMostEnds);
  if (kind == CutKind::seam) ends.insert(ends.end(), sources.begin(), sources.end());
  std::set<CutEnds> cuts;
  for (const VertexHandle end : ends) {
    const SmoothPaths from_end = paths.paths_from(end);
    std::vector<VertexHandle> landings;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      take_landings(loops[l], length_of(chart.mesh, chart.boundary_loops[l]), from_end, landings);
    }
    for (const VertexHandle start : landings) {
      if (kind == CutKind::seam) {
        cuts.insert({std::min(start, end), std::max(start, end)});
      } else {
        cuts.insert({start, end});
      }
    }
  }
  return {cuts.begin(), cuts.end()};
}

std::vector<CutEnds> neighbors_of(const Chart& chart, const SmoothPathFinder& paths, CutEnds cut) {
  std::vector<CutEnds> neighbors;
  const auto around = [&](VertexHandle v, const auto& take) {
    for (const VertexHandle next : chart.mesh.vv_range(v)) {
      if (chart.mesh.is_boundary(next) == chart.mesh.is_boundary(v) && !paths.is_barred(next)) take(next);
    }
  };
  around(cut.end, [&](VertexHandle v) { neighbors.push_back({cut.start, v}); });
  around(cut.start, [&](VertexHandle v) { neighbors.push_back({v, cut.end}); });
  return neighbors;
}

bool are_beside(const Chart& chart, CutEnds a, CutEnds b) {
  const auto apart = [&](VertexHandle v, VertexHandle w) { return (chart.mesh.point(v) - chart.mesh.point(w)).norm(); };
  const double least = kApart * std::sqrt(surface_area(chart.mesh));
  return std::max(apart(a.start, b.start), apart(a.end, b.end)) < least ||
         std::max(apart(a.start, b.end), apart(a.end, b.start)) < least;
}

HalfEdgeChain chain_of(const SmoothPathFinder& paths, CutEnds cut) {
  return paths.path_to(paths.paths_from(cut.start), cut.end);
}

}  // namespace wirewarp
