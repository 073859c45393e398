// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// This share of the spread's trace is added to the spread, to decide between equal axes. It is far above rounding
/// errors, and below the effect of the mesh on unequal axes.
constexpr double kDecides = 1e-7;

}  // namespace

Eigen::Matrix3d principal_axes(const HalfEdgeMesh& mesh, Eigen::Matrix3d spread) {
  const HalfedgeHandle h = mesh.halfedge_handle(FaceHandle(0));
  const auto at = [&](VertexHandle v) { return vector_of(mesh.point(v)); };
  const Eigen::Vector3d from = at(mesh.from_vertex_handle(h));
  const Eigen::Vector3d along = at(mesh.to_vertex_handle(h)) - from;
  const Eigen::Vector3d back = at(mesh.from_vertex_handle(mesh.prev_halfedge_handle(h))) - from;
  const Eigen::Vector3d& edge = along.norm() < back.norm() ? along : back;
  const Eigen::Vector3d normal = along.cross(back).normalized(), direction = edge.normalized();
  spread += kDecides * spread.trace() * (2 * normal * normal.transpose() + direction * direction.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
}

}  // namespace wirewarp
