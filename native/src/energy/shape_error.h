// SPDX-License-Identifier: GPL-3.0-or-later
// The shape error of Eq. (4), which measures how far a flat shape is from an isometry of its chart, and its gradient.
//
//   E(u) = Σ_t A [2(|z| - 1)² + 2|w|²],   J = [z₁+w₁, w₂-z₂; z₂+w₂, z₁-w₁]
//
//   A   3D area of triangle t
//   J   map of triangle t, linear in u; z = z₁ + i z₂ is its similarity part, w = w₁ + i w₂ its reflection part
//
// Eq. (6) sums ½ Σ cot θ |(u_i − u_i+1) − L (v_i − v_i+1)|² with the best-fitting rotation L. By the cotangent identity
// Σ cot θ |M e|² = 2A |M|², this equals A |J − L|². The singular values of J are |z| ± |w|, and L is ẑ = z/|z|. L is
// never a reflection, even for flipped triangles.
#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <vector>

#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

class ShapeError {
 public:
  explicit ShapeError(const Chart& chart);

  /// Returns E of a layout, scene units squared. uv: one row per chart vertex.
  double energy(const Positions2& uv) const;

  /// Returns E, and writes ∂E/∂uv to gradient. At z = 0, every rotation fits equally well, and E has a kink. There, the
  /// result is the middle of the possible gradients.
  double energy_and_gradient(const Positions2& uv, Positions2& gradient) const;

  /// Returns the number of flipped triangles and triangles with zero area.
  int count_flips(const Positions2& uv) const;

  /// Returns G d with the Gauss-Newton Hessian G of E at uv, from the derivatives of |z| and w. G is positive
  /// semidefinite. Unlike fixed_rotation_hessian(), G has no cost for rotating triangles.
  Positions2 times_gauss_newton(const Positions2& uv, const Positions2& d) const;

  /// Returns the lower triangle of K, the Hessian of E in each coordinate for fixed rotations. K is positive
  /// semidefinite.
  ///
  ///   K = Σ_t 2A NᵀN = twice the cotangent Laplacian,   N: gradients of the hat functions, one per column
  ///   E(u + d) ≤ E(u) + g·d + ½ d·Kd everywhere,        g = ∂E/∂u
  Eigen::SparseMatrix<double> fixed_rotation_hessian() const;

  /// A triangle p0 p1 p2, unfolded to (0, 0), (x1, 0), (x2, y2). The map from the unfolded triangle to u0 u1 u2 has the
  /// columns J₁ = a (u1 - u0) and J₂ = b (u1 - u0) + c (u2 - u0).
  struct Triangle {
    int vertices[3];
    double area;  // in 3D
    double a, b, c;

    /// Returns the gradients of the hat functions of the three vertices, one per column.
    Eigen::Matrix<double, 2, 3> hat_gradients() const {
      return (Eigen::Matrix<double, 2, 3>() << -a, a, 0, -b - c, b, c).finished();
    }
  };

  /// The map J of a triangle. Stores 2z, 2w and |2z|, because the factor 2 saves multiplications.
  struct LinearMap {
    double z1, z2, w1, w2;
    double norm_z;

    /// Returns |J - L|² = 2(|z| - 1)² + 2|w|².
    double squared_distance_from_rotation() const { return 0.5 * ((norm_z - 2) * (norm_z - 2) + w1 * w1 + w2 * w2); }
    Eigen::Matrix2d matrix() const {
      return 0.5 * (Eigen::Matrix2d() << z1 + w1, w2 - z2, z2 + w2, z1 - w1).finished();
    }
    /// Returns the largest factor by which a length grows or shrinks. The singular values are |z| ± |w|, or |w| ± |z|
    /// if the face is flipped.
    double worst_stretch() const {
      const double norm_w = std::hypot(w1, w2);
      return std::max((norm_z + norm_w) / 2, 2 / std::abs(norm_z - norm_w));
    }
    double determinant() const { return 0.25 * (norm_z * norm_z - w1 * w1 - w2 * w2); }
  };

  const std::vector<Triangle>& triangles() const { return triangles_; }
  static LinearMap map_of(const Triangle& triangle, const Positions2& uv);

 private:
  Eigen::Index num_vertices_;
  std::vector<Triangle> triangles_;
};

}  // namespace wirewarp
