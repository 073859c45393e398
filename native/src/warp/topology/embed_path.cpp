// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/embed_path.h"

#include <algorithm>

namespace wirewarp {
namespace {

/// Share of an edge within which a crossing snaps to the end of the edge, so that the path leaves no slivers.
constexpr double kNearVertex = 0.1;

PathPoint snap(const HalfEdgeMesh& mesh, const PathPoint& point, double reach) {
  if (point.t <= reach) return PathPoint::at_vertex(mesh.from_vertex_handle(point.half_edge));
  if (point.t >= 1 - reach) return PathPoint::at_vertex(mesh.to_vertex_handle(point.half_edge));
  return point;
}

bool touches(const HalfEdgeMesh& mesh, const PathPoint& point, VertexHandle v) {
  if (point.is_vertex()) return point.vertex == v;
  return mesh.from_vertex_handle(point.half_edge) == v || mesh.to_vertex_handle(point.half_edge) == v;
}

/// Appends a vertex to the path. Before that, removes crossings of the vertex's edges from the end of the path. If the
/// path has passed the vertex before, removes the loop between the two passes.
void pass_vertex(const HalfEdgeMesh& mesh, VertexHandle v, MeshPath& path) {
  const auto is_v = [&](const PathPoint& point) { return point.vertex == v; };
  path.erase(std::find_if(path.begin(), path.end(), is_v), path.end());
  while (!path.empty() && !path.back().is_vertex() && touches(mesh, path.back(), v)) path.pop_back();
  path.push_back(PathPoint::at_vertex(v));
}

/// Snaps a path. reach_of: returns the share of an edge within which a crossing snaps to an end. ends_at: called at
/// each vertex of the path; returns whether the path ends there.
template <class ReachOf, class EndsAt>
MeshPath snap_until(const HalfEdgeMesh& mesh, const MeshPath& path, const ReachOf& reach_of, const EndsAt& ends_at) {
  MeshPath snapped{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PathPoint point = path[i].is_vertex() ? path[i] : snap(mesh, path[i], reach_of(path[i]));
    if (point.is_vertex()) {
      pass_vertex(mesh, point.vertex, snapped);
      if (ends_at(point.vertex)) break;
    } else if (!snapped.back().is_vertex() || !touches(mesh, point, snapped.back().vertex)) {
      snapped.push_back(point);
    }
  }
  return snapped;
}

}  // namespace

MeshPath snap_to_vertices(const HalfEdgeMesh& mesh, const MeshPath& path, double reach) {
  return snap_until(
      mesh, path, [&](const PathPoint&) { return reach; }, [](VertexHandle) { return false; });
}

std::optional<MeshPath> snap_to_wires(const HalfEdgeMesh& mesh, const WireMask& wires, const MeshPath& path) {
  const VertexHandle start = path.front().vertex;
  const auto reach_of = [&](const PathPoint& point) {
    return wires.has(mesh.edge_handle(point.half_edge)) ? 0.5 : kNearVertex;
  };
  const MeshPath snapped = snap_until(mesh, path, reach_of, [&](VertexHandle v) { return v != start && wires.has(v); });
  const PathPoint& end = snapped.back();
  if (!end.is_vertex() || end.vertex == start || !wires.has(end.vertex)) return std::nullopt;
  if (snapped.size() == 2 && wires.has(mesh.edge_handle(mesh.find_halfedge(start, end.vertex)))) return std::nullopt;
  return snapped;
}

HalfEdgeChain embed_path(SplitChart& split, const MeshPath& path) {
  const HalfEdgeMesh& mesh = split.chart.mesh;
  HalfEdgeChain chain;
  VertexHandle last = path.front().vertex;
  for (std::size_t i = 1; i < path.size(); ++i) {
    // The last vertex is opposite to the next edge, so splitting this edge connects the last vertex with the new
    // vertex.
    const VertexHandle next = path[i].is_vertex() ? path[i].vertex : split_edge(split, path[i].half_edge, path[i].t);
    chain.push_back(mesh.find_halfedge(last, next));
    last = next;
  }
  return chain;
}

}  // namespace wirewarp
