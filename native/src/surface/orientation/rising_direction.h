// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the direction in the layout uv that best matches a direction in space: the gradient of the surface's height
/// along `up`, averaged over the layout's area. The direction is not normalized. It is zero if the piece is level, that
/// is, if the mean slope is below 1%, as for a flat lid or a whole dome.
Eigen::Vector2d rising_direction(const Chart& chart, const Positions2& uv, const Eigen::Vector3d& up);

}  // namespace wirewarp
