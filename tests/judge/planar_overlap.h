// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

namespace wirewarp::test {

using PlanarTriangle = std::array<Eigen::Vector2d, 3>;

/// Returns twice the signed area. The extended precision keeps the sign correct for thin triangles.
long double doubled_area(const PlanarTriangle& triangle);

/// Returns the indices of two triangles that overlap by more than rounding errors, or (-1, -1). All triangles must be
/// counter-clockwise.
std::pair<int, int> find_overlap(const std::vector<PlanarTriangle>& triangles);

}  // namespace wirewarp::test
