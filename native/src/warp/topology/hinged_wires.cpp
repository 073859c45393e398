// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/hinged_wires.h"

#include "warp/topology/embed_path.h"
#include "warp/topology/shortest_path.h"
#include "warp/topology/straightest_geodesic.h"

namespace wirewarp {
namespace {

/// Returns the wire edges that leave a vertex.
std::vector<HalfedgeHandle> wires_at(const SplitChart& refined, VertexHandle v) {
  const HalfEdgeMesh& mesh = refined.chart.mesh;
  std::vector<HalfedgeHandle> wires;
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    if (refined.wires.has(mesh.edge_handle(h))) wires.push_back(h);
  }
  return wires;
}

/// Marks all wire vertices except those of the tail's own wire from the tail to the first vertex where another wire
/// meets it, inclusive.
std::vector<char> other_wires(const SplitChart& refined, VertexHandle tail) {
  const HalfEdgeMesh& mesh = refined.chart.mesh;
  std::vector<char> is_other(mesh.n_vertices(), 0);
  for (const VertexHandle v : mesh.vertices()) is_other[v.idx()] = refined.wires.has(v) ? 1 : 0;
  HalfedgeHandle h = wires_at(refined, tail).front();
  is_other[tail.idx()] = 0;
  for (;;) {
    const VertexHandle v = mesh.to_vertex_handle(h);
    const std::vector<HalfedgeHandle> wires = wires_at(refined, v);
    is_other[v.idx()] = 0;
    if (wires.size() != 2) return is_other;
    h = wires[0] == mesh.opposite_halfedge_handle(h) ? wires[1] : wires[0];
  }
}

/// Whether a path winds around the surface: it is twice as long as the shortest edge path between its ends.
bool winds(const HalfEdgeMesh& mesh, const MeshPath& path) {
  constexpr double kTimesLonger = 2;
  const double length = path_length(mesh, path);
  const VertexHandle start = path.front().vertex;
  const VertexHandle end = path.back().vertex;
  if (length <= kTimesLonger * (mesh.point(end) - mesh.point(start)).norm()) return false;
  std::vector<char> is_target(mesh.n_vertices(), 0);
  is_target[end.idx()] = 1;
  double direct = 0;
  const std::vector<VertexHandle> way = shortest_edge_path(mesh, WireMask(), {start}, is_target);
  for (std::size_t i = 1; i < way.size(); ++i) direct += (mesh.point(way[i]) - mesh.point(way[i - 1])).norm();
  return length > kTimesLonger * direct;
}

void extend_tail(SplitChart& refined, VertexHandle tail, HalfedgeHandle wire) {
  const HalfEdgeMesh& mesh = refined.chart.mesh;
  std::optional<MeshPath> path = trace_straightest(mesh, refined.wires, wire, total_angle(mesh, tail) / 2);
  if (path) path = snap_to_wires(mesh, refined.wires, *path);
  if (path && !winds(mesh, *path)) {
    add_helper_wire(refined, embed_path(refined, *path));
  } else {
    join_by_shortest_path(refined, {tail}, other_wires(refined, tail));
  }
}

}  // namespace

void extend_hinged_wires(SplitChart& refined, WorkMeter& work) {
  const std::size_t num_vertices = refined.chart.mesh.n_vertices();  // helper wires do not end inside the chart
  for (std::size_t i = 0; i < num_vertices; ++i) {
    const VertexHandle v(static_cast<int>(i));
    work.did(1);
    if (!refined.wires.has(v)) continue;
    const std::vector<HalfedgeHandle> wires = wires_at(refined, v);
    if (wires.size() != 1) continue;
    extend_tail(refined, v, wires.front());
    work.did(num_vertices);  // the path passes few vertices, but the searches visit all of them
  }
}

}  // namespace wirewarp
