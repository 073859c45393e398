// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of one triangle of fabric as a function of its map.
//
//   J = (a; b)      the map worn → flat, with the rows a = ∇x (weft) and b = ∇y (warp)
//   p = |b|, q = |a|, g = a·b, D = det J
//   F = J⁻¹         the map flat → worn: its columns f_u, f_v are a weft and a warp thread of length 1,
//                   |f_u| = p/D, |f_v| = q/D, f_u·f_v = −g/D²
//
//   W = weft ρ(|f_u| − 1) + warp ρ(|f_v| − 1) + shear (f_u·f_v)² + 10 max(0, |sin γ| − sin γ₀)²     per flat area
//   ρ(x) = x², squeeze · x² where x < 0;   sin γ = f_u·f_v / (|f_u| |f_v|) = −g/(pq);   γ₀ the locking angle
//
//   φ = D W = weft (p − D)²/D + warp (q − D)²/D + shear g²/D³ + 10 D max(0, |g|/(pq) − sin γ₀)²     per worn area
//
// The threads and the shear of woven cloth are independent springs, as in D. E. Breen, D. H. House, M. J. Wozny (1994)
// and J. McCartney et al. (2000). W is not a barrier by itself: φ stays finite as a and b approach 0 together, and a
// mirror image has the same W. Therefore φ is defined as infinite for D <= 0.
//
// A fabric may be stretched by the shares c_weft and c_warp when worn. J is then the map to the stretched fabric: S
// times the map to the flat piece, with S = diag(1 + c_weft, 1 + c_warp). The energy measures the deviation from this
// stretch. W is then per area of the stretched fabric, which is det S times the flat area.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "wirewarp/cloth.h"

namespace wirewarp {

class ClothLaw {
 public:
  /// Divides all stiffnesses by the larger of weft and warp, so that only the ratios of the stiffnesses matter.
  explicit ClothLaw(const Cloth& cloth);

  struct Invariants {
    explicit Invariants(const Eigen::Matrix2d& map)
        : p(map.row(1).norm()),
          q(map.row(0).norm()),
          g(map.row(0).dot(map.row(1))),
          determinant(map(0, 0) * map(1, 1) - map(0, 1) * map(1, 0)) {}
    double p, q, g, determinant;
  };

  /// Returns φ; infinite if D <= 0.
  double density(const Eigen::Matrix2d& map) const;

  /// Returns ∂φ/∂J; zero if D <= 0.
  Eigen::Matrix2d gradient(const Eigen::Matrix2d& map) const;

  /// Returns ∂²φ/∂J² for the stacked vector (a, b). Needs D > 0.
  Eigen::Matrix4d hessian(const Eigen::Matrix2d& map) const;

  /// Returns ∂²φ/∂J² with its negative eigenvalues set to zero. Needs D > 0.
  Eigen::Matrix4d convex_hessian(const Eigen::Matrix2d& map) const;

  /// Returns a factor c such that, for an isometric map, c times the Hessian of ARAP is at least the Hessian of φ.
  double stiffness_at_rest() const;

 private:
  /// Derivatives of φ with respect to p, q, g and D.
  struct Expansion {
    Eigen::Vector4d slope;
    Eigen::Matrix4d curvature;
  };

  double value(const Invariants& of) const;

  Expansion expand(const Invariants& of) const;
  void add_locking(const Invariants& of, Expansion& by) const;

  double weft_, warp_, shear_, squeeze_;
  std::optional<double> locking_sine_;  // sin γ₀
};

}  // namespace wirewarp
