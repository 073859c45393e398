// SPDX-License-Identifier: GPL-3.0-or-later
// Distortion of one triangle: the ARAP energy of Eq. (4) and (6), the aspect ratio E_r and the signed area.
#pragma once

#include <Eigen/Core>

namespace wirewarp {

/// How a 3D triangle maps to the plane.
struct TriangleDistortion {
  double area_3d = 0;      // scene units squared
  double area_2d = 0;      // signed: negative where the triangle is flipped
  double sigma_1 = 1;      // larger singular value of the map
  double sigma_2 = 1;      // smaller one with the sign of the determinant: negative where the triangle is flipped
  double arap_energy = 0;  // E_A of Eq. (6)

  /// E_r = max(sigma_1, 1/|sigma_2|): 1 exactly on isometries, infinite on collapsed triangles. A flipped triangle is
  /// measured as its mirror image; that it is flipped, area_2d says.
  double aspect_ratio() const;
};

/// Measures the linear map that takes the triangle p (3D, front side counter-clockwise, area > 0) to u (planar).
///
/// Eq. (6), ½ Σ cot θ |(u_i − u_i+1) − L (v_i − v_i+1)|² with the rotation L that fits best, equals A |J − L|² by the
/// cotangent identity Σ cot θ |M e|² = 2A |M|². With J = [z₁+w₁, w₂−z₂; z₂+w₂, z₁−w₁] the singular values are |z| ± |w|
/// and L is the rotation along z, which leaves E_A = A [(σ₁−1)² + (σ₂−1)²] = A [2(|z|−1)² + 2|w|²].
TriangleDistortion measure_triangle(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& p2,
                                    const Eigen::Vector2d& u0, const Eigen::Vector2d& u1, const Eigen::Vector2d& u2);

}  // namespace wirewarp
