// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the direction in the layout uv that becomes up (+y) by options.orientation. It is not normalized, and zero
/// only if all points of the chain coincide.
///
/// - wire: along the wire options.grain. In charts without this wire, along the first wire. In charts without wires,
///   along the longest chain of the outline. +y is to the right of the chain by options.grain_angle.
/// - best: as for wire, without the angle
/// - boundary: straightest_outline()
/// - up: rising_direction() of options.up; as for best if this direction is zero
/// - grain: as for wire if options.grain crosses the chart, otherwise as for up
Eigen::Vector2d upright_direction(const Chart& chart, const Positions2& uv, const Options& options);

/// Rotates a layout so that up becomes +y, and moves its lower-left corner to the origin.
void stand_upright(Positions2& uv, const Eigen::Vector2d& up);

/// Returns two vertices of an upright layout that define its rotation: for Orientation::wire, the ends of an open
/// upright chain. Otherwise, they are the lowest and highest vertex of the outline.
VertexPair upright_pair(const Chart& chart, const Positions2& uv, const Options& options);

}  // namespace wirewarp
