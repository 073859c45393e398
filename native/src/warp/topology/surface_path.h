// SPDX-License-Identifier: GPL-3.0-or-later
// A path on a mesh: from vertex to vertex, straight across each triangle.
#pragma once

#include <algorithm>
#include <complex>
#include <vector>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// A vertex, or a point where the path crosses an edge.
struct PathPoint {
  VertexHandle vertex;       // valid if the point is a vertex
  HalfedgeHandle half_edge;  // otherwise the crossed edge, on the side of the face that the path leaves
  double t = 0;              // parameter along half_edge, 0 at its start and 1 at its end

  bool is_vertex() const { return vertex.is_valid(); }
  static PathPoint at_vertex(VertexHandle v) { return {v, HalfedgeHandle(), 0}; }
  static PathPoint on_edge(HalfedgeHandle h, double t) { return {VertexHandle(), h, t}; }
};

using MeshPath = std::vector<PathPoint>;

inline std::vector<FaceHandle> faces_at(const HalfEdgeMesh& mesh, VertexHandle v) {
  std::vector<FaceHandle> faces;
  for (const FaceHandle f : mesh.vf_range(v)) faces.push_back(f);
  return faces;
}

inline std::vector<FaceHandle> faces_at(const HalfEdgeMesh& mesh, const PathPoint& point) {
  if (point.is_vertex()) return faces_at(mesh, point.vertex);
  std::vector<FaceHandle> faces;
  for (const HalfedgeHandle h : {point.half_edge, mesh.opposite_halfedge_handle(point.half_edge)}) {
    if (!mesh.is_boundary(h)) faces.push_back(mesh.face_handle(h));
  }
  return faces;
}

inline bool have_common_face(const std::vector<FaceHandle>& a, const std::vector<FaceHandle>& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

inline HalfEdgeMesh::Point position(const HalfEdgeMesh& mesh, const PathPoint& point) {
  if (point.is_vertex()) return mesh.point(point.vertex);
  const auto from = mesh.point(mesh.from_vertex_handle(point.half_edge));
  return from + (mesh.point(mesh.to_vertex_handle(point.half_edge)) - from) * point.t;
}

inline double path_length(const HalfEdgeMesh& mesh, const MeshPath& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (position(mesh, path[i]) - position(mesh, path[i - 1])).norm();
  }
  return length;
}

// A vector in the plane of a triangle.
using Planar = std::complex<double>;

/// Returns a positive number if b points to the left of a.
inline double cross(Planar a, Planar b) { return std::imag(std::conj(a) * b); }

/// Returns the corner opposite to h in its face, in a plane where h runs from 0 along the real axis with its face on
/// the left.
inline Planar apex_over(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  const auto from = mesh.point(mesh.from_vertex_handle(h));
  const auto along = mesh.point(mesh.to_vertex_handle(h)) - from;
  const auto up = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))) - from;
  const double length = along.norm();
  return {(along | up) / length, (along % up).norm() / length};
}

}  // namespace wirewarp
