// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// The direction in the layout uv that corresponds best to a direction in space: the mean, over the layout's area, of
/// the gradient of the surface's height along up. Not normalized; zero where the piece is level: where the height rises
/// in no one direction by 1 % on average, as on a flat lid or a dome seen from above.
Eigen::Vector2d rising_direction(const Chart& chart, const Positions2& uv, const Eigen::Vector3d& up);

}  // namespace wirewarp
