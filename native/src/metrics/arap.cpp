// SPDX-License-Identifier: GPL-3.0-or-later
#include "metrics/arap.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace wirewarp {

double TriangleDistortion::aspect_ratio() const {
  if (sigma_2 == 0) return std::numeric_limits<double>::infinity();
  return std::max(sigma_1, 1 / std::abs(sigma_2));
}

TriangleDistortion measure_triangle(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& p2,
                                    const Eigen::Vector2d& u0, const Eigen::Vector2d& u1, const Eigen::Vector2d& u2) {
  // The 3D triangle laid into the plane: (0, 0), (x1, 0), (x2, y2).
  const Eigen::Vector3d e1 = p1 - p0;
  const Eigen::Vector3d e2 = p2 - p0;
  const double x1 = e1.norm();
  const double x2 = e1.dot(e2) / x1;
  const double y2 = e1.cross(e2).norm() / x1;

  const Eigen::Vector2d d1 = u1 - u0;
  const Eigen::Vector2d d2 = u2 - u0;
  const Eigen::Vector2d column_1 = d1 / x1;
  const Eigen::Vector2d column_2 = (d2 - column_1 * x2) / y2;

  const double z = 0.5 * Eigen::Vector2d(column_1.x() + column_2.y(), column_1.y() - column_2.x()).norm();
  const double w = 0.5 * Eigen::Vector2d(column_1.x() - column_2.y(), column_1.y() + column_2.x()).norm();

  TriangleDistortion result;
  result.area_3d = 0.5 * x1 * y2;
  result.area_2d = 0.5 * (d1.x() * d2.y() - d1.y() * d2.x());
  result.sigma_1 = z + w;
  result.sigma_2 = z - w;
  result.arap_energy = result.area_3d * 2 * ((z - 1) * (z - 1) + w * w);
  return result;
}

}  // namespace wirewarp
