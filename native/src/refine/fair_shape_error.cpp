// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/fair_shape_error.h"

#include <algorithm>

#include "mesh/geometry.h"

namespace wirewarp {
namespace {

using HatGradients = Eigen::Matrix<double, 2, 3>;
using PerCorner = Eigen::Matrix<double, 2, 3>;

constexpr double kOpen = 0.7;                 // |z| of a triangle that is not much compressed
constexpr double kSmallestDeterminant = 0.1;  // where the barrier begins

double kappa(double norm_z, Curvature curvature) {
  const double exact = norm_z > 0 ? 2 / norm_z : 1;  // norm_z is 2 |z|
  switch (curvature) {
    case Curvature::exact:
      return exact;
    case Curvature::exact_where_open:
      return norm_z >= 2 * kOpen ? exact : std::min(exact, 1.0);
    case Curvature::convex:
      return std::min(exact, 1.0);
    case Curvature::none:
      return 0;
  }
  return 0;
}

/// s_i = g_i · i ẑ.
PerCorner turned_hats(const HatGradients& g, const ShapeError::LinearMap& map) {
  if (!(map.norm_z > 0)) return PerCorner::Zero();
  const double x = map.z1 / map.norm_z, y = map.z2 / map.norm_z;
  return (Eigen::Matrix2d() << -y, -x, x, -y).finished() * g;
}

/// ∇_i det J = g_i z − ḡ_i w.
PerCorner determinant_gradient(const HatGradients& g, const ShapeError::LinearMap& map) {
  return 0.5 * (Eigen::Matrix2d() << map.z1 - map.w1, -map.z2 - map.w2, map.z2 - map.w2, map.z1 + map.w1).finished() *
         g;
}

/// M(ḡ_i g_j).
Eigen::Matrix2d conjugate_product(const HatGradients& g, int i, int j) {
  const double dot = g.col(i).dot(g.col(j)), cross = g(0, i) * g(1, j) - g(1, i) * g(0, j);
  return (Eigen::Matrix2d() << dot, -cross, cross, dot).finished();
}

}  // namespace

FairShapeError::FairShapeError(const Chart& chart, const WireNetwork& network, double fairness)
    : shape_error_(chart), bending_(chart, network, fairness, surface_area(chart.mesh)) {}

double FairShapeError::value(const Positions2& uv) const {
  double barrier = 0;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    const double lack = kSmallestDeterminant - ShapeError::map_of(t, uv).determinant();
    if (lack > 0) barrier += t.area * lack * lack;
  }
  return shape_error_.energy(uv) + bending_.value(uv) + flip_weight_ * barrier;
}

double FairShapeError::value_and_gradient(const Positions2& uv, Positions2& gradient) const {
  const double energy = shape_error_.energy_and_gradient(uv, gradient);
  double barrier = 0;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    const ShapeError::LinearMap map = ShapeError::map_of(t, uv);
    const double lack = kSmallestDeterminant - map.determinant();
    if (lack <= 0) continue;
    barrier += t.area * lack * lack;
    const PerCorner by_corner = -2 * flip_weight_ * t.area * lack * determinant_gradient(t.hat_gradients(), map);
    for (int i = 0; i < 3; ++i) gradient.row(t.vertices[i]) += by_corner.col(i).transpose();
  }
  return energy + bending_.add_gradient(uv, gradient) + flip_weight_ * barrier;
}

double FairShapeError::value_of_rounding(double error) const {
  double sum = 0;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) sum += 2 * t.area * t.hat_gradients().squaredNorm();
  return error * error * sum + bending_.value_of_rounding(error);
}

int FairShapeError::count_flips(const Positions2& uv) const {
  int flips = 0;
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    flips += ShapeError::map_of(t, uv).determinant() <= 0 ? 1 : 0;
  }
  return flips;
}

void FairShapeError::list_pairs(std::vector<VertexPair>& pairs) const {
  pairs.reserve(pairs.size() + 3 * shape_error_.triangles().size());
  for (const ShapeError::Triangle& t : shape_error_.triangles()) {
    for (int i = 0; i < 3; ++i) pairs.push_back({t.vertices[i], t.vertices[(i + 1) % 3]});
  }
  bending_.list_pairs(pairs);
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

void FairShapeError::add_constant_hessian(VertexMatrix& hessian) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const ShapeError::Triangle& t = shape_error_.triangles()[i];
    const HatGradients g = t.hat_gradients();
    add_triangle(i, hessian, [&](int a, int b) -> Eigen::Matrix2d {
      return 2 * t.area * g.col(a).dot(g.col(b)) * Eigen::Matrix2d::Identity();
    });
  }
  bending_.add_hessian(hessian);
}

void FairShapeError::add_curvature(const Positions2& uv, Curvature curvature, VertexMatrix& hessian) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const ShapeError::Triangle& t = shape_error_.triangles()[i];
    const ShapeError::LinearMap map = ShapeError::map_of(t, uv);
    const HatGradients g = t.hat_gradients();
    if (curvature != Curvature::none) {
      const PerCorner s = turned_hats(g, map);
      const double factor = -t.area * kappa(map.norm_z, curvature);
      add_triangle(i, hessian,
                   [&](int a, int b) -> Eigen::Matrix2d { return factor * s.col(a) * s.col(b).transpose(); });
    }
    const double lack = kSmallestDeterminant - map.determinant();
    if (lack <= 0) continue;
    const PerCorner by_corner = determinant_gradient(g, map);
    const double weight = flip_weight_ * t.area;
    add_triangle(i, hessian, [&](int a, int b) -> Eigen::Matrix2d {
      Eigen::Matrix2d bend = weight * lack * conjugate_product(g, a, b);
      if (curvature == Curvature::exact) {
        bend(0, 1) *= 2, bend(1, 0) *= 2;
        bend(0, 0) = bend(1, 1) = 0;
      }
      return 2 * weight * by_corner.col(a) * by_corner.col(b).transpose() + bend;
    });
  }
}

}  // namespace wirewarp
