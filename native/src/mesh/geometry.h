// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths and angles of a half-edge mesh, in double precision and without cancellation.
#pragma once

#include <cmath>

#include "mesh/half_edge_mesh.h"

namespace wirewarp {

inline double edge_length(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  return (mesh.point(mesh.to_vertex_handle(h)) - mesh.point(mesh.from_vertex_handle(h))).norm();
}

/// Angle of h's face at the vertex h leaves, radians in (0, pi).
inline double corner_angle(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  const auto origin = mesh.point(mesh.from_vertex_handle(h));
  const auto along = mesh.point(mesh.to_vertex_handle(h)) - origin;
  const auto back = mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(h))) - origin;
  return std::atan2((along % back).norm(), along | back);
}

/// The half-edge that leaves the same vertex one face counter-clockwise from h, which has a face.
inline HalfedgeHandle next_counterclockwise(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}

}  // namespace wirewarp
