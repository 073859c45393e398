// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the mean gradient of the surface's height along `up`, in the layout uv. Returns zero if the mean slope is
/// below 1%, as for a flat lid or a dome. The direction is not normalized.
Eigen::Vector2d rising_direction(const Chart& chart, const Positions2& uv, const Eigen::Vector3d& up);

}  // namespace wirewarp
