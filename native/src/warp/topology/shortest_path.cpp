// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/shortest_path.h"

#include <algorithm>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/shortest_paths.h"
#include "warp/topology/embed_path.h"
#include "warp/topology/strip.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {
namespace {

/// Returns whether the path is shorter around the other side of the vertex, because the angle on that side is below 180
/// degrees.
bool is_shorter_on_other_side(const HalfEdgeMesh& mesh, const StripTurn& turn) {
  constexpr double kStraight = 1e-9;  // radians, a thousand times the rounding error of a sum of angles
  return total_angle(mesh, turn.vertex) - kPi - turn.angle < kPi - kStraight;
}

/// Replaces the strip with a strip that may_take accepts and that has a shorter path. Returns false if there is none.
template <class MayTake>
bool improve(const HalfEdgeMesh& mesh, const WireMask& wires, const MayTake& may_take, Strip& strip, StripPath& best) {
  // The new path must be shorter by this share, some hundred rounding errors, so that equally long paths do not
  // alternate.
  constexpr double kNoShorter = 1e-13;
  for (const StripTurn& turn : best.turns) {
    if (!is_shorter_on_other_side(mesh, turn)) continue;
    Strip other = pass_on_other_side(mesh, strip, turn);
    if (!may_take(other)) continue;
    StripPath path = shortest_in_strip(mesh, wires, other);
    if (path.length >= best.length * (1 - kNoShorter)) continue;
    strip = std::move(other);
    best = std::move(path);
    return true;
  }
  return false;
}

template <class MayTake>
MeshPath shortest_path(const HalfEdgeMesh& mesh, const WireMask& wires, const std::vector<VertexHandle>& edge_path,
                       const MayTake& may_take) {
  Strip strip = strip_beside(mesh, edge_path);
  StripPath best = shortest_in_strip(mesh, wires, strip);
  while (improve(mesh, wires, may_take, strip, best)) {
  }
  return best.path;
}

}  // namespace

std::vector<VertexHandle> shortest_edge_path(const HalfEdgeMesh& mesh, const WireMask& wires,
                                             const std::vector<VertexHandle>& sources,
                                             const std::vector<char>& is_target) {
  const auto ends_at = [&](VertexHandle v) { return is_target[v.idx()] != 0; };
  const auto may_follow = [&](HalfedgeHandle h) {
    const VertexHandle next = mesh.to_vertex_handle(h);
    return !wires.has(mesh.edge_handle(h)) && (!wires.has(next) || ends_at(next));
  };
  const ShortestPaths paths = shortest_paths(mesh, sources, {may_follow, ends_at});
  if (!paths.end.is_valid()) return {};
  std::vector<VertexHandle> path{paths.end};
  for (const HalfedgeHandle h : path_back(mesh, paths, paths.end)) path.push_back(mesh.from_vertex_handle(h));
  std::reverse(path.begin(), path.end());
  return path;
}

MeshPath straighten(const HalfEdgeMesh& mesh, const WireMask& wires, const std::vector<VertexHandle>& edge_path) {
  return shortest_path(mesh, wires, edge_path, [](const Strip&) { return true; });
}

MeshPath straighten_nearby(const HalfEdgeMesh& mesh, const WireMask& wires,
                           const std::vector<VertexHandle>& edge_path) {
  std::vector<char> touches_path(mesh.n_faces(), 0);
  for (const VertexHandle v : edge_path) {
    for (const FaceHandle f : mesh.vf_range(v)) touches_path[f.idx()] = 1;
  }
  return shortest_path(mesh, wires, edge_path, [&](const Strip& strip) {
    return std::all_of(strip.crossings.begin(), strip.crossings.end(), [&](HalfedgeHandle h) {
      return touches_path[mesh.face_handle(h).idx()] != 0 &&
             touches_path[mesh.face_handle(mesh.opposite_halfedge_handle(h)).idx()] != 0;
    });
  });
}

HalfEdgeChain join_by_shortest_path(SplitChart& split, const std::vector<VertexHandle>& sources,
                                    std::vector<char> is_target) {
  make_room(split, sources);
  const HalfEdgeMesh& mesh = split.chart.mesh;
  is_target.resize(mesh.n_vertices(), 0);
  const std::vector<VertexHandle> edge_path = shortest_edge_path(mesh, split.wires, sources, is_target);
  if (edge_path.empty()) throw UnjoinedWires("No path leads from one wire loop to another in the same region.");
  const MeshPath straight = straighten(mesh, split.wires, edge_path);
  const std::optional<MeshPath> path = snap_to_wires(mesh, split.wires, straight);
  if (!path) throw UnjoinedWires("A shortest path between wire loops ends off its loops.");
  HalfEdgeChain chain = embed_path(split, *path);
  add_helper_wire(split, chain);
  return chain;
}

}  // namespace wirewarp
