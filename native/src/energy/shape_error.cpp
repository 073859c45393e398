// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/shape_error.h"

#include <algorithm>
#include <cmath>

namespace wirewarp {
namespace {

/// Adds the derivatives with respect to the corners of a triangle. r, s: derivatives with respect to 2z and 2w, which
/// LinearMap stores.
inline void add_to_corners(const ShapeError::Triangle& t, double r1, double r2, double s1, double s2,
                           Positions2& gradient) {
  const double p11 = r1 + s1, p21 = r2 + s2, p12 = s2 - r2, p22 = r1 - s1;  // derivatives with respect to J
  const double g1x = t.a * p11 + t.b * p12, g1y = t.a * p21 + t.b * p22;
  const double g2x = t.c * p12, g2y = t.c * p22;
  double* g0 = &gradient(t.vertices[0], 0);
  double* g1 = &gradient(t.vertices[1], 0);
  double* g2 = &gradient(t.vertices[2], 0);
  g0[0] -= g1x + g2x;
  g0[1] -= g1y + g2y;
  g1[0] += g1x;
  g1[1] += g1y;
  g2[0] += g2x;
  g2[1] += g2y;
}

}  // namespace

ShapeError::ShapeError(const Chart& chart) : num_vertices_(static_cast<Eigen::Index>(chart.mesh.n_vertices())) {
  const HalfEdgeMesh& mesh = chart.mesh;
  triangles_.reserve(mesh.n_faces());
  for (const FaceHandle face : mesh.faces()) {
    const HalfedgeHandle h = mesh.halfedge_handle(face);
    const VertexHandle v0 = mesh.from_vertex_handle(h), v1 = mesh.to_vertex_handle(h);
    const VertexHandle v2 = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
    const OpenMesh::Vec3d e1 = mesh.point(v1) - mesh.point(v0), e2 = mesh.point(v2) - mesh.point(v0);
    const double x1 = e1.norm();
    const double x2 = OpenMesh::dot(e1, e2) / x1;
    const double y2 = OpenMesh::cross(e1, e2).norm() / x1;
    triangles_.push_back({{v0.idx(), v1.idx(), v2.idx()}, 0.5 * x1 * y2, 1 / x1, -x2 / (x1 * y2), 1 / y2});
  }
}

ShapeError::LinearMap ShapeError::map_of(const Triangle& t, const Positions2& uv) {
  const auto u0 = uv.row(t.vertices[0]), u1 = uv.row(t.vertices[1]), u2 = uv.row(t.vertices[2]);
  const double d1x = u1.x() - u0.x(), d1y = u1.y() - u0.y();
  const double d2x = u2.x() - u0.x(), d2y = u2.y() - u0.y();
  const double j11 = t.a * d1x, j21 = t.a * d1y;
  const double j12 = t.b * d1x + t.c * d2x, j22 = t.b * d1y + t.c * d2y;
  const double z1 = j11 + j22, z2 = j21 - j12;
  return {z1, z2, j11 - j22, j21 + j12, std::sqrt(z1 * z1 + z2 * z2)};
}

double ShapeError::energy(const Positions2& uv) const {
  double sum = 0;
  for (const Triangle& t : triangles_) sum += t.area * map_of(t, uv).squared_distance_from_rotation();
  return sum;
}

double ShapeError::energy_and_gradient(const Positions2& uv, Positions2& gradient) const {
  gradient.setZero(num_vertices_, 2);
  double sum = 0;
  for (const Triangle& t : triangles_) {
    const LinearMap map = map_of(t, uv);
    sum += t.area * map.squared_distance_from_rotation();

    // ∂E/∂J = 2A (J - L). Its similarity part is A (2z - 2ẑ), and its reflection part is A 2w.
    const double stretch = map.norm_z > 0 ? 1 - 2 / map.norm_z : 1;
    add_to_corners(t, t.area * stretch * map.z1, t.area * stretch * map.z2, t.area * map.w1, t.area * map.w2, gradient);
  }
  return sum;
}

int ShapeError::count_flips(const Positions2& uv) const {
  return static_cast<int>(std::count_if(triangles_.begin(), triangles_.end(),
                                        [&](const Triangle& t) { return map_of(t, uv).determinant() <= 0; }));
}

/// With Z = 2z and W = 2w, which LinearMap stores, E of a triangle is A/2 [(|Z| - 2)² + |W|²].
Positions2 ShapeError::times_gauss_newton(const Positions2& uv, const Positions2& d) const {
  Positions2 product = Positions2::Zero(num_vertices_, 2);
  for (const Triangle& t : triangles_) {
    const LinearMap map = map_of(t, uv), change = map_of(t, d);
    const double square = map.norm_z * map.norm_z;
    const double stretch = square > 0 ? t.area * (map.z1 * change.z1 + map.z2 * change.z2) / square : 0;
    add_to_corners(t, stretch * map.z1, stretch * map.z2, t.area * change.w1, t.area * change.w2, product);
  }
  return product;
}

Eigen::SparseMatrix<double> ShapeError::fixed_rotation_hessian() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * triangles_.size());
  for (const Triangle& t : triangles_) {
    const Eigen::Matrix<double, 2, 3> hats = t.hat_gradients();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        const auto [column, row] = std::minmax(t.vertices[i], t.vertices[j]);
        entries.emplace_back(row, column, 2 * t.area * hats.col(i).dot(hats.col(j)));
      }
    }
  }
  Eigen::SparseMatrix<double> lower(num_vertices_, num_vertices_);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace wirewarp
