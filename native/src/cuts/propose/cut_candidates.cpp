// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/cut_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/shortest_paths.h"

namespace wirewarp {
namespace {

/// A landing has a cheaper path than all points within this share of the outline on each side. Both shares together are
/// about the distance between two points spread along the outline.
constexpr double kWindow = 1.0 / 24;

/// The outline has a corner where it turns by more than this angle, in radians. A ring of twelve edges turns by this
/// angle, so finer rings have no corners.
constexpr double kCorner = kPi / 6;

/// A value counts as larger only if it exceeds the other value by this factor, so that rounding errors in rotated input
/// do not decide which value is larger.
constexpr double kClearly = 1 + 1e-9;

/// Largest distance, over √area, between ends of cuts that count as near each other. The points spread over the inside
/// are typically 0.2 apart, so cuts that end at different points are not near each other.
constexpr double kApart = 0.15;

struct OutlinePoint {
  VertexHandle vertex;
  double at = 0;    // position along the loop, scene units
  double turn = 0;  // turn of the outline, radians
};

using OutlineLoop = std::vector<OutlinePoint>;

OutlineLoop measure_loop(const Chart& chart, const HalfEdgeChain& half_edges) {
  OutlineLoop loop;
  double at = 0;
  for (const HalfedgeHandle h : half_edges) {
    const VertexHandle v = chart.mesh.from_vertex_handle(h);
    loop.push_back({v, at, std::abs(total_angle(chart.mesh, v) - kPi)});
    at += edge_length(chart.mesh, h);
  }
  return loop;
}

/// Adds the landings on a loop: see list_candidates(). length: length of the loop.
void add_landings(const OutlineLoop& loop, double length, const SmoothPaths& paths, std::vector<VertexHandle>& taken) {
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
    if (is_least) taken.push_back(loop[i].vertex);
  }
}

/// Returns at most `count` of the allowed vertices, each as far as possible from the sources and from the vertices
/// before it. may_take: one flag per vertex.
std::vector<VertexHandle> spread(const Chart& chart, std::vector<VertexHandle> sources,
                                 const std::vector<char>& may_take, int count) {
  std::vector<VertexHandle> taken;
  while (static_cast<int>(taken.size()) < count) {
    const ShortestPaths paths = shortest_paths(chart.mesh, sources);
    int farthest = -1;
    for (int v = 0; v < static_cast<int>(may_take.size()); ++v) {
      if (may_take[v] != 0 && paths.distance[v] > 0 &&
          (farthest < 0 || paths.distance[v] > kClearly * paths.distance[farthest]))
        farthest = v;
    }
    if (farthest < 0) break;
    taken.push_back(VertexHandle(farthest));
    sources.push_back(VertexHandle(farthest));
  }
  return taken;
}

std::vector<VertexHandle> spread_on_outline(const Chart& chart, const std::vector<OutlineLoop>& loops,
                                            const SmoothPathFinder& paths, int count) {
  std::vector<char> is_corner(chart.mesh.n_vertices(), 0), is_on_outline = is_corner;
  VertexHandle sharpest;
  double sharpest_turn = -1;
  for (const OutlineLoop& loop : loops) {
    for (const OutlinePoint& point : loop) {
      if (paths.is_forbidden(point.vertex)) continue;
      is_on_outline[point.vertex.idx()] = 1;
      is_corner[point.vertex.idx()] = point.turn > kCorner ? 1 : 0;
      if (point.turn <= kClearly * sharpest_turn) continue;
      sharpest = point.vertex;
      sharpest_turn = point.turn;
    }
  }
  if (!sharpest.is_valid()) return {};
  std::vector<VertexHandle> points{sharpest};
  for (const auto& [may_take, most] : {std::pair(is_corner, count / 2), std::pair(is_on_outline, count)}) {
    const std::vector<VertexHandle> more = spread(chart, points, may_take, most - static_cast<int>(points.size()));
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

std::vector<VertexHandle> spread_inside(const Chart& chart, const SmoothPathFinder& paths, int count) {
  std::vector<char> may_take(chart.mesh.n_vertices(), 0);
  for (const VertexHandle v : chart.mesh.vertices()) {
    may_take[v.idx()] = chart.mesh.is_boundary(v) || paths.is_forbidden(v) ? 0 : 1;
  }
  return spread(chart, boundary_vertices(chart.mesh), may_take, count);
}

/// Returns the ends of a cut. The ends of a seam are interchangeable, so the end with the lower number comes first.
CutEnds in_one_order(const Chart& chart, CutEnds cut) {
  const bool is_seam = chart.mesh.is_boundary(cut.start) && chart.mesh.is_boundary(cut.end);
  return is_seam && cut.end < cut.start ? CutEnds{cut.end, cut.start} : cut;
}

}  // namespace

std::vector<CutEnds> list_candidates(const Chart& chart, const SmoothPathFinder& paths, CutKind kind,
                                     CandidatePoints count) {
  std::vector<OutlineLoop> loops;
  for (const HalfEdgeChain& loop : chart.boundary_loops) loops.push_back(measure_loop(chart, loop));
  const std::vector<VertexHandle> on_outline = spread_on_outline(chart, loops, paths, count.on_outline);
  std::set<CutEnds> cuts;
  for (const VertexHandle end : kind == CutKind::seam ? on_outline : spread_inside(chart, paths, count.inside)) {
    const SmoothPaths from_end = paths.paths_from(end);
    std::vector<VertexHandle> starts;
    for (const VertexHandle start : on_outline) {
      if (from_end.arrival[start.idx()].is_valid()) starts.push_back(start);
    }
    for (std::size_t l = 0; l < loops.size(); ++l) {
      add_landings(loops[l], length_of(chart.mesh, chart.boundary_loops[l]), from_end, starts);
    }
    for (const VertexHandle start : starts) {
      cuts.insert(in_one_order(chart, {start, end}));
    }
  }
  return {cuts.begin(), cuts.end()};
}

std::vector<CutEnds> neighbors_of(const Chart& chart, const SmoothPathFinder& paths, CutEnds cut) {
  std::vector<CutEnds> neighbors;
  const auto around = [&](VertexHandle v, const auto& take) {
    for (const VertexHandle next : chart.mesh.vv_range(v)) {
      if (chart.mesh.is_boundary(next) == chart.mesh.is_boundary(v) && !paths.is_forbidden(next)) take(next);
    }
  };
  around(cut.end, [&](VertexHandle v) { neighbors.push_back(in_one_order(chart, {cut.start, v})); });
  around(cut.start, [&](VertexHandle v) { neighbors.push_back(in_one_order(chart, {v, cut.end})); });
  return neighbors;
}

bool are_beside(const HalfEdgeMesh& mesh, double size, CutEnds a, CutEnds b) {
  const auto apart = [&](VertexHandle v, VertexHandle w) { return (mesh.point(v) - mesh.point(w)).norm(); };
  const double least = kApart * size;
  return std::max(apart(a.start, b.start), apart(a.end, b.end)) < least ||
         std::max(apart(a.start, b.end), apart(a.end, b.start)) < least;
}

HalfEdgeChain chain_of(const SmoothPathFinder& paths, CutEnds cut) {
  return paths.path_to(paths.paths_from(cut.start), cut.end);
}

}  // namespace wirewarp
