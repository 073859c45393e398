// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/smooth_line.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "warp/topology/embed_path.h"
#include "warp/topology/shortest_path.h"
#include "warp/topology/strip.h"

namespace wirewarp {
namespace {

/// Share of an edge within which a line snaps to the edge's end, to avoid slivers. With edges of 10 mm, the line stays
/// within 2 mm of the shortest line.
constexpr double kReach = 0.05;

/// Straightens each section between two vertices in its strip of triangles.
MeshPath straight_between_vertices(const HalfEdgeMesh& mesh, const WireMask& lines, const MeshPath& path) {
  MeshPath straight{path.front()};
  Strip strip{path.front().vertex, VertexHandle(), {}};
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!path[i].is_vertex()) {
      strip.crossings.push_back(path[i].half_edge);
      continue;
    }
    strip.end = path[i].vertex;
    const MeshPath section = shortest_in_strip(mesh, lines, strip).path;
    straight.insert(straight.end(), section.begin() + 1, section.end());
    strip = {strip.end, VertexHandle(), {}};
  }
  return straight;
}

std::ptrdiff_t num_vertices(const MeshPath& path) {
  return std::count_if(path.begin(), path.end(), [](const PathPoint& point) { return point.is_vertex(); });
}

double angle_between(const HalfEdgeMesh::Point& a, const HalfEdgeMesh::Point& b) {
  return std::atan2((a % b).norm(), a | b);
}

/// Returns whether a point is on the edge of h, but not at the start of h.
bool is_toward(const HalfEdgeMesh& mesh, const PathPoint& point, HalfedgeHandle h) {
  if (point.is_vertex()) return point.vertex == mesh.to_vertex_handle(h);
  return mesh.edge_handle(point.half_edge) == mesh.edge_handle(h);
}

/// Returns the angle around a vertex from its first half-edge to a point in an adjacent triangle.
double direction_of(const HalfEdgeMesh& mesh, VertexHandle v, const PathPoint& point) {
  double angle = 0;
  const HalfedgeHandle first = mesh.halfedge_handle(v);
  HalfedgeHandle h = first;
  do {
    if (is_toward(mesh, point, h)) return angle;
    if (is_toward(mesh, point, mesh.next_halfedge_handle(h))) {
      return angle +
             angle_between(mesh.point(mesh.to_vertex_handle(h)) - mesh.point(v), position(mesh, point) - mesh.point(v));
    }
    angle += corner_angle(mesh, h);
    h = next_counterclockwise(mesh, h);
  } while (h != first);
  throw std::logic_error("A path leads from a vertex to a point outside the triangles of this vertex.");
}

double turn_at_vertex(const HalfEdgeMesh& mesh, VertexHandle v, const PathPoint& before, const PathPoint& after) {
  const double full = total_angle(mesh, v);
  double left = direction_of(mesh, v, before) - direction_of(mesh, v, after);
  if (left < 0) left += full;
  return std::abs(kPi - left * 2 * kPi / full);
}

double turn_at_edge(const HalfEdgeMesh& mesh, const PathPoint& at, const PathPoint& before, const PathPoint& after) {
  const HalfEdgeMesh::Point place = position(mesh, at);
  const HalfEdgeMesh::Point along = mesh.point(mesh.to_vertex_handle(at.half_edge)) - place;
  return std::abs(kPi - angle_between(position(mesh, before) - place, along) -
                  angle_between(along, position(mesh, after) - place));
}

}  // namespace

MeshPath smooth_line(const HalfEdgeMesh& mesh, const WireMask& lines, const std::vector<VertexHandle>& path,
                     Nearness nearness) {
  const MeshPath straight =
      nearness == Nearness::touching ? straighten_nearby(mesh, lines, path) : straighten(mesh, lines, path);
  MeshPath line = snap_to_vertices(mesh, straight, kReach);
  // Moving a crossing to a vertex bends the line, so the sections between vertices are straightened again.
  for (std::ptrdiff_t before = 0; num_vertices(line) > before;) {
    before = num_vertices(line);
    line = snap_to_vertices(mesh, straight_between_vertices(mesh, lines, line), kReach);
  }
  return line;
}

double sharpest_turn(const HalfEdgeMesh& mesh, const MeshPath& path) {
  double sharpest = 0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double turn = path[i].is_vertex() ? turn_at_vertex(mesh, path[i].vertex, path[i - 1], path[i + 1])
                                            : turn_at_edge(mesh, path[i], path[i - 1], path[i + 1]);
    sharpest = std::max(sharpest, turn);
  }
  return sharpest;
}

}  // namespace wirewarp
