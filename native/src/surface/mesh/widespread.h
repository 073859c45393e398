// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace wirewarp {

/// Returns the value below which 99% of the area lies; single slivers do not matter. Both arguments: one entry per
/// face.
double widespread(const std::vector<double>& areas, const Eigen::VectorXd& of_faces);

}  // namespace wirewarp
