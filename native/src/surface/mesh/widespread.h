// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace wirewarp {

/// Returns the largest value of a face after the faces with the largest values, up to 1% of the area, were left out.
/// Therefore, single slivers do not matter. Both arguments: one entry per face.
double widespread(const std::vector<double>& areas, const Eigen::VectorXd& of_faces);

}  // namespace wirewarp
