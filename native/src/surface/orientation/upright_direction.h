// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the direction in the layout uv that becomes up (+y) by options.orientation. The direction is not normalized.
/// It is zero only if all points of the chain coincide.
///
/// wire: along the first part of the wire options.grain in this chart, otherwise along the chart's first wire part;
/// without wires, along the longest chain of the outline. A chain's direction is its chord. For a chain that is closed
/// or nearly closed, the direction is the long side of the smallest box around the chain, with the chain's first vertex
/// in the lower half. boundary: straightest_outline(). up: rising_direction() of options.up; as for wire if this
/// direction is zero. best: as for wire. grain: as for wire if options.grain crosses this chart, as for up otherwise.
///
/// For wire, and for grain in charts that the wire crosses, options.grain_angle rotates the direction: +y is to the
/// right of the chain by this angle.
Eigen::Vector2d upright_direction(const Chart& chart, const Positions2& uv, const Options& options);

/// Rotates a layout so that up becomes +y, and moves its lower-left corner to the origin.
void stand_upright(Positions2& uv, const Eigen::Vector2d& up);

/// Returns two vertices of an upright layout that define its rotation. For Orientation::wire or grain, these are the
/// ends of the wire or chain that defines up, unless this chain is nearly closed. Otherwise, they are the lowest and
/// the highest vertex of the outline. At equal heights, the leftmost vertex is used, so that the numbering of the mesh
/// does not matter.
VertexPair upright_pair(const Chart& chart, const Positions2& uv, const Options& options);

}  // namespace wirewarp
