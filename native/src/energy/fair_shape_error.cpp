// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/fair_shape_error.h"

#include <algorithm>
#include <cmath>

#include "base/planar.h"
#include "energy/log_barrier.h"
#include "surface/mesh/connected_parts.h"

namespace wirewarp {
namespace {

using HatGradients = Eigen::Matrix<double, 2, 3>;
using PerCorner = Eigen::Matrix<double, 2, 3>;

// The barrier acts below this determinant. Triangles of good pieces have larger determinants.
constexpr double kSmallestDeterminant = 0.1;
// ω: at zero area, the barrier is about as large as E of a triangle that is a third too short in one direction.
constexpr double kFiniteWeight = 10;
// κ = ω · 0.1², so that both barriers have the same curvature at a determinant of 0.075.
constexpr double kInfiniteWeight = 0.1;

double kappa(double norm_z, Curvature curvature) {
  const double exact = norm_z > 0 ? 2 / norm_z : 1;  // norm_z is 2 |z|
  switch (curvature) {
    case Curvature::exact:
      return exact;
    case Curvature::convex:
      return std::min(exact, 1.0);
    case Curvature::none:
      return 0;
  }
  return 0;
}

/// Returns s_i = g_i · i ẑ.
PerCorner turned_hats(const HatGradients& g, const ShapeError::LinearMap& map) {
  if (!(map.norm_z > 0)) return PerCorner::Zero();
  const double x = map.z1 / map.norm_z, y = map.z2 / map.norm_z;
  return (Eigen::Matrix2d() << -y, -x, x, -y).finished() * g;
}

/// Returns ∇_i det J = g_i z − ḡ_i w.
PerCorner determinant_gradient(const HatGradients& g, const ShapeError::LinearMap& map) {
  return 0.5 * (Eigen::Matrix2d() << map.z1 - map.w1, -map.z2 - map.w2, map.z2 - map.w2, map.z1 + map.w1).finished() *
         g;
}

/// Returns M(ḡ_i g_j).
Eigen::Matrix2d conjugate_product(const HatGradients& g, int i, int j) {
  const double dot = g.col(i).dot(g.col(j)), cross = g(0, i) * g(1, j) - g(1, i) * g(0, j);
  return (Eigen::Matrix2d() << dot, -cross, cross, dot).finished();
}

}  // namespace

FairShapeError::FairShapeError(const Chart& chart, const HeldNetwork& network, double fairness, const Cloth* cloth,
                               Injectivity injectivity, const Positions2& layout)
    : shape_error_(chart),
      bending_(bending_of(chart, network, fairness, area_at_vertices(chart.mesh))),
      injectivity_(injectivity) {
  if (cloth) cloth_.emplace(ClothTerms{ClothLaw(*cloth), shear_smoothing_of(chart)});
  if (injectivity == Injectivity::global) outline_barrier_.emplace(chart, layout);
}

/// The determinant must be below kSmallestDeterminant, because the finite barrier would grow again above it.
FairShapeError::FlipBarrier FairShapeError::flip_barrier(double determinant) const {
  if (injectivity_ == Injectivity::none) {
    const double lack = kSmallestDeterminant - determinant;
    return {kFiniteWeight * lack * lack, -2 * kFiniteWeight * lack, 2 * kFiniteWeight};
  }
  const LogBarrier barrier(determinant / kSmallestDeterminant);
  return {kInfiniteWeight * barrier.value, kInfiniteWeight / kSmallestDeterminant * barrier.slope,
          kInfiniteWeight / (kSmallestDeterminant * kSmallestDeterminant) * barrier.curvature};
}

double FairShapeError::energy(const Positions2& uv) const {
  if (!cloth_) return shape_error_.energy(uv);
  double sum = cloth_->smoothing.value(uv);
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    sum += t.area * cloth_->law.density(ShapeError::map_of(t, uv).matrix());
  }
  return sum;
}

/// Returns f without fairness and barriers. Overwrites the gradient.
double FairShapeError::energy_and_gradient(const Positions2& uv, Positions2& gradient) const {
  if (!cloth_) return shape_error_.energy_and_gradient(uv, gradient);
  gradient.setZero(uv.rows(), 2);
  double sum = cloth_->smoothing.add_gradient(uv, gradient);
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    const Eigen::Matrix2d map = ShapeError::map_of(t, uv).matrix();
    sum += t.area * cloth_->law.density(map);
    const PerCorner by_corner = t.area * cloth_->law.gradient(map) * t.hat_gradients();
    for (int i = 0; i < 3; ++i) gradient.row(t.vertices[i]) += by_corner.col(i).transpose();
  }
  return sum;
}

double FairShapeError::value(const Positions2& uv) const {
  double barrier = 0;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    const double determinant = ShapeError::map_of(t, uv).determinant();
    if (determinant < kSmallestDeterminant) barrier += t.area * flip_barrier(determinant).value;
  }
  if (outline_barrier_) barrier += outline_barrier_->value(uv);
  return energy(uv) + bending_.value(uv) + barrier;
}

double FairShapeError::value_and_gradient(const Positions2& uv, Positions2& gradient) const {
  const double energy = energy_and_gradient(uv, gradient);
  double barrier = 0;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    const ShapeError::LinearMap map = ShapeError::map_of(t, uv);
    if (map.determinant() >= kSmallestDeterminant) continue;
    const FlipBarrier of_triangle = flip_barrier(map.determinant());
    barrier += t.area * of_triangle.value;
    const PerCorner by_corner = t.area * of_triangle.slope * determinant_gradient(t.hat_gradients(), map);
    for (int i = 0; i < 3; ++i) gradient.row(t.vertices[i]) += by_corner.col(i).transpose();
  }
  if (outline_barrier_) barrier += outline_barrier_->add_gradient(uv, gradient);
  return energy + bending_.add_gradient(uv, gradient) + barrier;
}

double FairShapeError::value_of_rounding(double error) const {
  double sum = 0;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) sum += 2 * t.area * t.hat_gradients().squaredNorm();
  if (cloth_) sum = cloth_->law.stiffness_at_rest() * sum + cloth_->smoothing.value_of_rounding(1);
  return error * error * sum + bending_.value_of_rounding(error);
}

/// The area of each triangle is a quadratic function a + bt + ct² of the share t of the step, positive at t = 0. The
/// smallest positive root limits the step.
double FairShapeError::longest_step(const Positions2& uv, const Positions2& d) const {
  if (injectivity_ == Injectivity::none) return 1;
  double longest = outline_barrier_ ? outline_barrier_->longest_step(uv, d) : 1;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    const auto side = [&](const Positions2& of, int k) -> Eigen::Vector2d {
      return of.row(t.vertices[k]) - of.row(t.vertices[0]);
    };
    const Eigen::Vector2d e1 = side(uv, 1), e2 = side(uv, 2), d1 = side(d, 1), d2 = side(d, 2);
    const double a = cross(e1, e2), b = cross(e1, d2) + cross(d1, e2), c = cross(d1, d2);
    const double discriminant = b * b - 4 * a * c;
    const double q = discriminant >= 0 ? std::sqrt(discriminant) - b : 0;
    if (q > 0) longest = std::min(longest, 2 * a / q);
  }
  return longest;
}

void FairShapeError::list_pairs(std::vector<VertexPair>& pairs) const {
  pairs.reserve(pairs.size() + 3 * shape_error_.triangles().size());
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    for (int i = 0; i < 3; ++i) pairs.push_back({t.vertices[i], t.vertices[(i + 1) % 3]});
  }
  bending_.list_pairs(pairs);
  if (cloth_) cloth_->smoothing.list_pairs(pairs);
  if (outline_barrier_) outline_barrier_->list_pairs(pairs);
}

void FairShapeError::attach_to(const VertexMatrix& hessian) {
  blocks_.clear();
  blocks_.reserve(shape_error_.triangles().size());
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    TriangleBlocks blocks{{0, 1, 2}, {}};
    std::sort(blocks.order, blocks.order + 3, [&](int i, int j) { return t.vertices[i] > t.vertices[j]; });
    const auto vertex = [&](int k) { return t.vertices[blocks.order[k]]; };
    blocks.off_diagonal[0] = hessian.block(vertex(0), vertex(1));
    blocks.off_diagonal[1] = hessian.block(vertex(0), vertex(2));
    blocks.off_diagonal[2] = hessian.block(vertex(1), vertex(2));
    blocks_.push_back(blocks);
  }
}

/// Adds block_of(i, j), 2 by 2, for the corners i and j of triangle t.
template <class BlockOf>
void FairShapeError::add_triangle(std::size_t t, VertexMatrix& hessian, const BlockOf& block_of) const {
  const auto& vertices = shape_error_.triangles()[t].vertices;
  const TriangleBlocks& blocks = blocks_[t];
  const int i = blocks.order[0], j = blocks.order[1], k = blocks.order[2];
  hessian.add(blocks.off_diagonal[0], block_of(i, j));
  hessian.add(blocks.off_diagonal[1], block_of(i, k));
  hessian.add(blocks.off_diagonal[2], block_of(j, k));
  for (int corner = 0; corner < 3; ++corner) hessian.add_diagonal(vertices[corner], block_of(corner, corner));
}

void FairShapeError::add_laplacian(std::size_t i, VertexMatrix& hessian) const {
  const ShapeError::Triangle& t = shape_error_.triangles()[i];
  const HatGradients g = t.hat_gradients();
  add_triangle(i, hessian, [&](int a, int b) -> Eigen::Matrix2d {
    return 2 * t.area * g.col(a).dot(g.col(b)) * Eigen::Matrix2d::Identity();
  });
}

void FairShapeError::add_constant_hessian(VertexMatrix& hessian) const {
  if (cloth_) {
    cloth_->smoothing.add_hessian(hessian);
  } else {
    for (std::size_t i = 0; i < blocks_.size(); ++i) add_laplacian(i, hessian);
  }
  bending_.add_hessian(hessian);
}

/// With a cloth, adds the Hessian of φ, or the Laplacian for Curvature::none. Without a cloth, adds the Hessian of E
/// minus the Laplacian, which add_constant_hessian() has added.
void FairShapeError::add_energy_curvature(std::size_t i, const ShapeError::LinearMap& map, Curvature curvature,
                                          VertexMatrix& hessian) const {
  const ShapeError::Triangle& t = shape_error_.triangles()[i];
  const HatGradients g = t.hat_gradients();
  if (cloth_ && curvature == Curvature::none) {
    add_laplacian(i, hessian);
  } else if (cloth_) {
    const bool is_convex = curvature == Curvature::convex;
    const Eigen::Matrix4d of_map =
        t.area * (is_convex ? cloth_->law.convex_hessian(map.matrix()) : cloth_->law.hessian(map.matrix()));
    add_triangle(i, hessian, [&](int a, int b) -> Eigen::Matrix2d {
      Eigen::Matrix2d block;
      for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column) {
          block(row, column) = g.col(a).dot(of_map.block<2, 2>(2 * row, 2 * column) * g.col(b));
        }
      }
      return block;
    });
  } else if (curvature != Curvature::none) {
    const PerCorner s = turned_hats(g, map);
    const double factor = -t.area * kappa(map.norm_z, curvature);
    add_triangle(i, hessian, [&](int a, int b) -> Eigen::Matrix2d { return factor * s.col(a) * s.col(b).transpose(); });
  }
}

void FairShapeError::add_curvature(const Positions2& uv, Curvature curvature, VertexMatrix& hessian) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const ShapeError::Triangle& t = shape_error_.triangles()[i];
    const ShapeError::LinearMap map = ShapeError::map_of(t, uv);
    add_energy_curvature(i, map, curvature, hessian);
    if (map.determinant() >= kSmallestDeterminant) continue;
    const HatGradients g = t.hat_gradients();
    const PerCorner by_corner = determinant_gradient(g, map);
    const FlipBarrier barrier = flip_barrier(map.determinant());
    add_triangle(i, hessian, [&](int a, int b) -> Eigen::Matrix2d {
      Eigen::Matrix2d bend = -t.area / 2 * barrier.slope * conjugate_product(g, a, b);
      if (curvature == Curvature::exact) {
        bend(0, 1) *= 2, bend(1, 0) *= 2;
        bend(0, 0) = bend(1, 1) = 0;
      }
      return t.area * barrier.curvature * by_corner.col(a) * by_corner.col(b).transpose() + bend;
    });
  }
  if (outline_barrier_) outline_barrier_->add_hessian(uv, hessian);
}

}  // namespace wirewarp
