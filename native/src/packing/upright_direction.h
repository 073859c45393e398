// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "charts/chart.h"

namespace wirewarp {

/// The direction in the layout uv that should point up (+y): along the first wire part; without wires, along the
/// longest chain of the outline. A chain's direction is that of its chord, or of its longest extent if it closes or
/// nearly so. Not normalized; zero only if all of the chain lies in one point.
Eigen::Vector2d upright_direction(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
