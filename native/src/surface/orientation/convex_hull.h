// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace wirewarp {

/// Returns the corners of the convex hull, counter-clockwise (A. M. Andrew's monotone chain, 1979).
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

}  // namespace wirewarp
