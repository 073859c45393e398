// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/parts/part_planes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "surface/mesh/geometry.h"
#include "surface/mesh/principal_axes.h"

namespace wirewarp {
namespace {

/// Weight of a part's centroid beside the middles of its outlines, which have the weight 1. The weight is small,
/// because the centroid should determine the plane only if all middles are on one line.
constexpr double kCentroid = 0.1;

/// Planes count as the same if the cosine of the angle between their normals is above this value. Two planes at this
/// angle, 11 degrees, have only 6% of a ball between them.
constexpr double kSameNormal = 0.98;

/// Parallel planes count as the same if their distance is at most this share of √area, a rounding error.
constexpr double kSamePlace = 1e-9;

/// Normals of length 1 are projected to the mirror plane, so that each plane is symmetric. If the projected normal is
/// shorter than this value, the normal of the mirror plane replaces it. Both normals are then within 17 degrees, and
/// the projection would more than triple errors of the direction.
constexpr double kInPlane = 0.3;

/// Returns the sum of area times x xᵀ over all faces, where x is the face's centroid relative to a point.
Eigen::Matrix3d spread_around(const HalfEdgeMesh& mesh, const Eigen::Vector3d& point) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const FaceHandle f : mesh.faces()) {
    const Eigen::Vector3d x = vector_of(mesh.calc_face_centroid(f)) - point;
    spread += face_area(mesh, f) * x * x.transpose();
  }
  return spread;
}

/// Returns the centroid of a loop, weighted by length.
Eigen::Vector3d middle_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& loop) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double length = 0;
  for (const HalfedgeHandle h : loop) {
    const double own = edge_length(mesh, h);
    const HalfEdgeMesh::Point &from = mesh.point(mesh.from_vertex_handle(h)),
                              &to = mesh.point(mesh.to_vertex_handle(h));
    sum += own / 2 * (vector_of(from) + vector_of(to));
    length += own;
  }
  return sum / length;
}

}  // namespace

Plane Plane::mirrored(const Plane& mirror) const {
  const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - 2 * v.dot(mirror.normal) * mirror.normal;
  };
  return {mirror.point + across(point - mirror.point), across(normal)};
}

Eigen::VectorXd distances_from(const Plane& plane, const HalfEdgeMesh& mesh) {
  return (points_of(mesh).rowwise() - plane.point.transpose()) * plane.normal;
}

Plane mirror_plane(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image) {
  Plane plane{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const VertexHandle v : mesh.vertices()) {
    const Eigen::Vector3d here = vector_of(mesh.point(v)), there = vector_of(mesh.point(image[v.idx()]));
    plane.point += (here + there) / 2 / static_cast<double>(mesh.n_vertices());
    if ((here - there).norm() > plane.normal.norm()) plane.normal = here - there;
  }
  plane.normal.normalize();
  return plane;
}

Eigen::Vector3d centroid_of(const HalfEdgeMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const FaceHandle f : mesh.faces()) sum += face_area(mesh, f) * vector_of(mesh.calc_face_centroid(f));
  return sum / surface_area(mesh);
}

std::vector<Plane> planes_through(const Chart& part, const std::optional<Eigen::Vector3d>& strained,
                                  const std::optional<Plane>& mirror) {
  const HalfEdgeMesh& mesh = part.mesh;
  const Eigen::Vector3d center = centroid_of(mesh);
  const Eigen::Matrix3d spread = spread_around(mesh, center), axes = principal_axes(mesh, spread);
  std::vector<Plane> planes;
  const auto to_mirror = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    return mirror ? point - (point - mirror->point).dot(mirror->normal) * mirror->normal : point;
  };
  const auto add = [&](Plane plane) {
    plane.point = to_mirror(plane.point);
    if (mirror) {
      const double across = plane.normal.dot(mirror->normal);
      plane.normal -= across * mirror->normal;
      plane.normal = plane.normal.norm() < kInPlane ? mirror->normal : plane.normal.normalized();
    }
    const bool is_known = std::any_of(planes.begin(), planes.end(), [&](const Plane& known) {
      return std::abs(known.normal.dot(plane.normal)) > kSameNormal;
    });
    if (!is_known) planes.push_back(plane);
  };
  // Adds two planes that contain a line. Their normals are the principal axes of the spread across the line.
  const auto add_along = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
    const Eigen::Matrix3d frame = principal_axes(mesh, across * spread * across);
    for (const int k : {1, 2}) add({point, (across * frame.col(k)).normalized()});
  };
  std::vector<Eigen::Vector3d> middles;
  for (const HalfEdgeChain& loop : part.boundary_loops) middles.push_back(middle_of(mesh, loop));
  if (middles.size() == 1 && (center - middles[0]).norm() > 0) add_along(center, (center - middles[0]).normalized());
  if (middles.size() == 2) add_along((middles[0] + middles[1]) / 2, (middles[1] - middles[0]).normalized());
  if (middles.size() > 2) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& each : middles) middle += each / static_cast<double>(middles.size());
    Eigen::Matrix3d around = kCentroid * (center - middle) * (center - middle).transpose();
    for (const Eigen::Vector3d& each : middles) around += (each - middle) * (each - middle).transpose();
    add({middle, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(around).eigenvectors().col(0)});
  }
  for (int k = 0; k < 3; ++k) add({center, axes.col(k)});
  const std::size_t count = strained ? planes.size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Plane parallel{to_mirror(*strained), planes[i].normal};
    const double apart = std::abs((parallel.point - planes[i].point).dot(parallel.normal));
    if (apart > kSamePlace * std::sqrt(surface_area(mesh))) planes.push_back(parallel);
  }
  return planes;
}

}  // namespace wirewarp
