// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths and angles of a half-edge mesh, in double precision and without cancellation.
#pragma once

#include <cmath>
#include <vector>

#include "surface/mesh/half_edge_mesh.h"
#include "wirewarp/types.h"

namespace wirewarp {

inline Eigen::Vector3d vector_of(const HalfEdgeMesh::Point& p) { return {p[0], p[1], p[2]}; }

inline double edge_length(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  return (mesh.point(mesh.to_vertex_handle(h)) - mesh.point(mesh.from_vertex_handle(h))).norm();
}

inline double planar_length(const HalfEdgeMesh& mesh, HalfedgeHandle h, const Positions2& uv) {
  return (uv.row(mesh.to_vertex_handle(h).idx()) - uv.row(mesh.from_vertex_handle(h).idx())).norm();
}

inline double length_of(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& chain) {
  double length = 0;
  for (const HalfedgeHandle h : chain) length += edge_length(mesh, h);
  return length;
}

inline std::vector<VertexHandle> vertices_along(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& chain) {
  std::vector<VertexHandle> vertices{mesh.from_vertex_handle(chain.front())};
  for (const HalfedgeHandle h : chain) vertices.push_back(mesh.to_vertex_handle(h));
  return vertices;
}

/// Returns the angle of h's face at the vertex that h leaves, radians in (0, pi).
inline double corner_angle(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  const auto origin = mesh.point(mesh.from_vertex_handle(h));
  const auto along = mesh.point(mesh.to_vertex_handle(h)) - origin;
  const auto back = mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(h))) - origin;
  return std::atan2((along % back).norm(), along | back);
}

/// Returns the sum of the angles of all faces at a vertex, radians.
inline double total_angle(const HalfEdgeMesh& mesh, VertexHandle v) {
  double sum = 0;
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    if (!mesh.is_boundary(h)) sum += corner_angle(mesh, h);
  }
  return sum;
}

/// Returns the half-edge that leaves the same vertex one face counter-clockwise from h. h must have a face.
inline HalfedgeHandle next_counterclockwise(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}

inline double face_area(const HalfEdgeMesh& mesh, FaceHandle f) {
  const HalfedgeHandle h = mesh.halfedge_handle(f);
  const auto origin = mesh.point(mesh.from_vertex_handle(h));
  const auto along = mesh.point(mesh.to_vertex_handle(h)) - origin;
  const auto back = mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(h))) - origin;
  return (along % back).norm() / 2;
}

inline double surface_area(const HalfEdgeMesh& mesh) {
  double area = 0;
  for (const FaceHandle f : mesh.faces()) area += face_area(mesh, f);
  return area;
}

inline Positions3 points_of(const HalfEdgeMesh& mesh) {
  Positions3 points(static_cast<Eigen::Index>(mesh.n_vertices()), 3);
  for (const VertexHandle v : mesh.vertices()) {
    points.row(v.idx()) << mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2];
  }
  return points;
}

/// Returns the corners of each face, starting at its first half-edge. The result is #faces by 3.
inline Triangles triangles_of(const HalfEdgeMesh& mesh) {
  Triangles triangles(static_cast<Eigen::Index>(mesh.n_faces()), 3);
  for (const FaceHandle f : mesh.faces()) {
    HalfedgeHandle h = mesh.halfedge_handle(f);
    for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
      triangles(f.idx(), k) = mesh.from_vertex_handle(h).idx();
    }
  }
  return triangles;
}

}  // namespace wirewarp
