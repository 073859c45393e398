// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace wirewarp {

/// What 99 % of the area stay below: single slivers say nothing about a piece. Both arguments: one per face.
double widespread(const std::vector<double>& areas, const Eigen::VectorXd& of_faces);

}  // namespace wirewarp
