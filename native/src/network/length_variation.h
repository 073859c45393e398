// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "charts/chart.h"

namespace wirewarp {

/// h that a layout gives each wire part: its 2D over its 3D length, less 1. uv: one row per chart vertex.
Eigen::VectorXd length_variation(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
