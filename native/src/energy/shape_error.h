// SPDX-License-Identifier: GPL-3.0-or-later
// The shape error of Eq. (4): how far a flat shape is from an isometry of its chart, with its gradient.
//
//   E(u) = Σ_t A [2(|z| - 1)² + 2|w|²],   J = [z₁+w₁, w₂-z₂; z₂+w₂, z₁-w₁]   the map of triangle t, linear in u
//
// Eq. (6) sums ½ Σ cot θ |(u_i − u_i+1) − L (v_i − v_i+1)|² with the rotation L that fits best. By the cotangent
// identity Σ cot θ |M e|² = 2A |M|² that is A |J − L|². The singular values of J are |z| ± |w|, and L is ẑ = z/|z|: a
// flipped triangle is measured against the best rotation, never against a reflection.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

class ShapeError {
 public:
  explicit ShapeError(const Chart& chart);

  /// E of a layout, scene units squared. uv has one row per chart vertex.
  double energy(const Positions2& uv) const;

  /// The same, and ∂E/∂uv. Where z = 0, on mirror images of similar triangles and on points, E has a kink and every
  /// rotation fits equally well: there ẑ = 0 is taken, the middle of the possible gradients.
  double energy_and_gradient(const Positions2& uv, Positions2& gradient) const;

  /// Flipped triangles, and those without area.
  int count_flips(const Positions2& uv) const;

  /// G d with the Gauss-Newton Hessian of E at uv, of |z| and w alone: K without what turning the triangles costs.
  /// Positive semidefinite.
  Positions2 times_gauss_newton(const Positions2& uv, const Positions2& d) const;

  /// The lower triangle of K = Σ_t 2A GᵀG, with G the gradients of the hat functions: twice the cotangent Laplacian,
  /// positive semidefinite on every mesh. For both coordinates it is the Hessian of E with all rotations held, and with
  /// g = ∂E/∂uv bounds E everywhere:
  ///
  ///   E(u + d) ≤ E(u) + g·d + ½ d·Kd
  Eigen::SparseMatrix<double> fixed_rotation_hessian() const;

  /// The triangle p0 p1 p2 laid into the plane is (0, 0), (x1, 0), (x2, y2). The map that takes it to u0 u1 u2 has the
  /// columns J₁ = a (u1 - u0) and J₂ = b (u1 - u0) + c (u2 - u0).
  struct Triangle {
    int vertices[3];
    double area;  // in 3D
    double a, b, c;

    /// Gradients of the hat functions of the three vertices, one a column.
    Eigen::Matrix<double, 2, 3> hat_gradients() const {
      return (Eigen::Matrix<double, 2, 3>() << -a, a, 0, -b - c, b, c).finished();
    }
  };

  /// Twice z and w: no halves in the loop.
  struct LinearMap {
    double z1, z2, w1, w2;
    double norm_z;

    /// |J - L|² = 2(|z| - 1)² + 2|w|².
    double squared_distance_from_rotation() const { return 0.5 * ((norm_z - 2) * (norm_z - 2) + w1 * w1 + w2 * w2); }
    /// J.
    Eigen::Matrix2d matrix() const {
      return 0.5 * (Eigen::Matrix2d() << z1 + w1, w2 - z2, z2 + w2, z1 - w1).finished();
    }
    /// det J = |z|² - |w|².
    double determinant() const { return 0.25 * (norm_z * norm_z - w1 * w1 - w2 * w2); }
  };

  const std::vector<Triangle>& triangles() const { return triangles_; }
  static LinearMap map_of(const Triangle& triangle, const Positions2& uv);

 private:
  Eigen::Index num_vertices_;
  std::vector<Triangle> triangles_;
};

}  // namespace wirewarp
