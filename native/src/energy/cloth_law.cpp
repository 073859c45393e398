// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/cloth_law.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace wirewarp {
namespace {

// The factor of the locking term in W. With 10, a woven fabric has as much energy 15° beyond its locking angle as at a
// thread strain of 50%. The Newton systems remain well conditioned.
constexpr double kLockingStiffness = 10;

enum Index { kP, kQ, kG, kD };

/// Returns ∂(p, q, g, D)/∂(a, b): one row for each of p, q, g and D.
Eigen::Matrix4d jacobian(const Eigen::Matrix2d& map, const ClothLaw::Invariants& of) {
  const double a1 = map(0, 0), a2 = map(0, 1), b1 = map(1, 0), b2 = map(1, 1);
  Eigen::Matrix4d rows;
  rows << 0, 0, b1 / of.p, b2 / of.p,  //
      a1 / of.q, a2 / of.q, 0, 0,      //
      b1, b2, a1, a2,                  //
      b2, -b1, -a2, a1;
  return rows;
}

/// The energy of a thread: stiffness (r − D)²/D. The reach r is p for weft and q for warp, and D is the determinant.
struct Thread {
  Thread(double thread_stiffness, double squeeze, double reach, double determinant)
      : stiffness(reach < determinant ? thread_stiffness * squeeze : thread_stiffness), ratio(reach / determinant) {}

  double value(double determinant) const { return stiffness * (ratio - 1) * (ratio - 1) * determinant; }
  double by_reach() const { return 2 * stiffness * (ratio - 1); }
  double by_determinant() const { return stiffness * (1 - ratio * ratio); }

  double stiffness, ratio;
};

}  // namespace

ClothLaw::ClothLaw(const Cloth& cloth) {
  const double stiffest = std::max(cloth.weft, cloth.warp);
  weft_ = cloth.weft / stiffest;
  warp_ = cloth.warp / stiffest;
  shear_ = cloth.shear / stiffest;
  squeeze_ = cloth.squeeze;
  if (cloth.locking) locking_sine_ = std::sin(*cloth.locking);
}

double ClothLaw::value(const Invariants& of) const {
  const double d = of.determinant;
  const Thread weft(weft_, squeeze_, of.p, d), warp(warp_, squeeze_, of.q, d);
  const double value = weft.value(d) + warp.value(d) + shear_ * of.g * of.g / (d * d * d);
  if (!locking_sine_) return value;
  const double excess = std::max(0.0, std::abs(of.g) / (of.p * of.q) - *locking_sine_);
  return value + kLockingStiffness * d * excess * excess;
}

ClothLaw::Expansion ClothLaw::expand(const Invariants& of) const {
  const double d = of.determinant;
  const Thread weft(weft_, squeeze_, of.p, d), warp(warp_, squeeze_, of.q, d);
  const double shear = of.g / (d * d);
  Expansion by;
  by.slope << weft.by_reach(), warp.by_reach(), 2 * shear_ * shear / d,
      weft.by_determinant() + warp.by_determinant() - 3 * shear_ * shear * shear;
  const double weft_bend = 2 * weft.stiffness / d, warp_bend = 2 * warp.stiffness / d;
  const double of_determinant =
      weft_bend * weft.ratio * weft.ratio + warp_bend * warp.ratio * warp.ratio + 12 * shear_ * shear * shear / d;
  by.curvature << weft_bend, 0, 0, -weft_bend * weft.ratio,           //
      0, warp_bend, 0, -warp_bend * warp.ratio,                       //
      0, 0, 2 * shear_ / (d * d * d), -6 * shear_ * shear / (d * d),  //
      -weft_bend * weft.ratio, -warp_bend * warp.ratio, -6 * shear_ * shear / (d * d), of_determinant;
  if (locking_sine_) add_locking(of, by);
  return by;
}

/// Adds the derivatives of 10 D m², where s = |g|/(pq) and m = s − sin γ₀.
void ClothLaw::add_locking(const Invariants& of, Expansion& by) const {
  const double sine = std::abs(of.g) / (of.p * of.q), excess = sine - *locking_sine_;
  if (!(excess > 0)) return;
  const double sign = std::copysign(1.0, of.g), pq = of.p * of.q;
  const Eigen::Vector4d slope(-sine / of.p, -sine / of.q, sign / pq, 0);  // gradient of s
  Eigen::Matrix4d bend;                                                   // Hessian of s
  bend << 2 * sine / (of.p * of.p), sine / pq, -sign / (of.p * pq), 0,    //
      sine / pq, 2 * sine / (of.q * of.q), -sign / (of.q * pq), 0,        //
      -sign / (of.p * pq), -sign / (of.q * pq), 0, 0,                     //
      0, 0, 0, 0;
  const double d = of.determinant, twice = 2 * kLockingStiffness;
  by.slope += twice * d * excess * slope;
  by.slope[kD] += kLockingStiffness * excess * excess;
  by.curvature += twice * d * (slope * slope.transpose() + excess * bend);
  by.curvature.col(kD) += twice * excess * slope;
  by.curvature.row(kD) += twice * excess * slope.transpose();
}

double ClothLaw::density(const Eigen::Matrix2d& map) const {
  const Invariants of(map);
  return of.determinant > 0 ? value(of) : std::numeric_limits<double>::infinity();
}

Eigen::Matrix2d ClothLaw::gradient(const Eigen::Matrix2d& map) const {
  const Invariants of(map);
  if (!(of.determinant > 0)) return Eigen::Matrix2d::Zero();
  const Eigen::Vector4d by_rows = jacobian(map, of).transpose() * expand(of).slope;
  return (Eigen::Matrix2d() << by_rows[0], by_rows[1], by_rows[2], by_rows[3]).finished();
}

Eigen::Matrix4d ClothLaw::hessian(const Eigen::Matrix2d& map) const {
  const Invariants of(map);
  const Expansion by = expand(of);
  const Eigen::Matrix4d rows = jacobian(map, of);
  Eigen::Matrix4d hessian = rows.transpose() * by.curvature * rows;
  // The second derivatives of p and q depend on the map. The second derivatives of g and D are constant.
  const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity();
  const Eigen::RowVector2d along_a = map.row(0) / of.q, along_b = map.row(1) / of.p;
  hessian.topLeftCorner<2, 2>() += by.slope[kQ] / of.q * (identity - along_a.transpose() * along_a);
  hessian.bottomRightCorner<2, 2>() += by.slope[kP] / of.p * (identity - along_b.transpose() * along_b);
  const Eigen::Matrix2d mixed = by.slope[kG] * identity + by.slope[kD] * (Eigen::Matrix2d() << 0, 1, -1, 0).finished();
  hessian.topRightCorner<2, 2>() += mixed;
  hessian.bottomLeftCorner<2, 2>() += mixed.transpose();
  return hessian;
}

Eigen::Matrix4d ClothLaw::convex_hessian(const Eigen::Matrix2d& map) const {
  const Eigen::Matrix4d exact = hessian(map);
  // Tries a factorization first, because it takes a tenth of the time of the eigenvalues.
  if (Eigen::LLT<Eigen::Matrix4d>(exact).info() == Eigen::Success) return exact;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(exact);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

double ClothLaw::stiffness_at_rest() const { return std::max({1.0, squeeze_, 2 * shear_}); }

}  // namespace wirewarp
