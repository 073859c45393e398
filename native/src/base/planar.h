// SPDX-License-Identifier: GPL-3.0-or-later
// What angles and areas in the plane are written with.
#pragma once

#include <Eigen/Core>

namespace wirewarp {

constexpr double kPi = 3.14159265358979323846;

/// Twice the area of the triangle between two planar vectors; positive where b lies to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace wirewarp
