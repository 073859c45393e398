// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors, angles and areas in the plane.
#pragma once

#include <Eigen/Core>

namespace wirewarp {

constexpr double kPi = 3.14159265358979323846;

/// Returns twice the signed area of the triangle between two planar vectors; positive if b is to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace wirewarp
