// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/hinged_wires.h"

#include "surface/mesh/geometry.h"
#include "warp/topology/embed_path.h"
#include "warp/topology/shortest_path.h"
#include "warp/topology/straightest_geodesic.h"

namespace wirewarp {
namespace {

std::vector<HalfedgeHandle> wires_at(const SplitChart& split, VertexHandle v) {
  const HalfEdgeMesh& mesh = split.chart.mesh;
  std::vector<HalfedgeHandle> wires;
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    if (split.wires.has(mesh.edge_handle(h))) wires.push_back(h);
  }
  return wires;
}

/// Marks all wire vertices that a helper wire from a tail may reach. Omits the vertices of the tail's own wire up to
/// and including the first vertex where another wire meets it.
std::vector<char> other_wires(const SplitChart& split, VertexHandle tail) {
  const HalfEdgeMesh& mesh = split.chart.mesh;
  std::vector<char> is_other(mesh.n_vertices(), 0);
  for (const VertexHandle v : mesh.vertices()) is_other[v.idx()] = split.wires.has(v) ? 1 : 0;
  HalfedgeHandle h = wires_at(split, tail).front();
  is_other[tail.idx()] = 0;
  for (;;) {
    const VertexHandle v = mesh.to_vertex_handle(h);
    const std::vector<HalfedgeHandle> wires = wires_at(split, v);
    is_other[v.idx()] = 0;
    if (wires.size() != 2) return is_other;
    h = wires[0] == mesh.opposite_halfedge_handle(h) ? wires[1] : wires[0];
  }
}

/// Returns whether a path winds around the surface: whether it is more than twice as long as the shortest edge path
/// between its ends. With 1.5 instead of 2, no shape of 400 random cases changes; with 3, two shapes change.
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

void extend_tail(SplitChart& split, VertexHandle tail, HalfedgeHandle wire) {
  const HalfEdgeMesh& mesh = split.chart.mesh;
  std::optional<MeshPath> path = trace_straightest(mesh, split.wires, wire, total_angle(mesh, tail) / 2);
  if (path) path = snap_to_wires(mesh, split.wires, *path);
  if (path && !winds(mesh, *path)) {
    add_helper_wire(split, embed_path(split, *path));
  } else {
    join_by_shortest_path(split, {tail}, other_wires(split, tail));
  }
}

}  // namespace

void extend_hinged_wires(SplitChart& split, WorkMeter& work) {
  const std::size_t num_vertices = split.chart.mesh.n_vertices();  // without new vertices, which are not ends of wires
  for (std::size_t i = 0; i < num_vertices; ++i) {
    const VertexHandle v(static_cast<int>(i));
    work.did(1);
    if (!split.wires.has(v)) continue;
    const std::vector<HalfedgeHandle> wires = wires_at(split, v);
    if (wires.size() != 1) continue;
    extend_tail(split, v, wires.front());
    work.did(num_vertices);  // the path passes few vertices, but the search visits all vertices
  }
}

}  // namespace wirewarp
