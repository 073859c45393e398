// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "charts/chart.h"

namespace wirewarp {

/// The direction in the layout uv that should point up (+y), as options.orientation says. Not normalized; zero only if
/// all of the chain lies in one point.
///
/// wire: along the first part of the wire options.grain in this chart, else along its first wire part; without wires,
/// along the longest chain of the outline. A chain's direction is that of its chord; if it closes or nearly so, the
/// long side of the smallest box around it, its first vertex in the lower half.
/// boundary: straightest_outline(). up: rising_direction() of options.up, and where that is zero, as by wire.
Eigen::Vector2d upright_direction(const Chart& chart, const Positions2& uv, const Options& options);

}  // namespace wirewarp
