// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace wirewarp::test {

/// Returns the Delaunay triangulation of points in general position, counter-clockwise (A. Bowyer, D. F. Watson, 1981).
/// The time grows with the square of their number. Slivers may be missing at the hull.
std::vector<std::array<int, 3>> delaunay(const std::vector<Eigen::Vector2d>& points);

}  // namespace wirewarp::test
