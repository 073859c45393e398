// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// The direction in the layout uv that should point up (+y), as options.orientation says. Not normalized; zero only if
/// all of the chain lies in one point.
///
/// wire: along the first part of the wire options.grain in this chart, else along its first wire part; without wires,
/// along the longest chain of the outline. A chain's direction is that of its chord; if it closes or nearly so, the
/// long side of the smallest box around it, its first vertex in the lower half.
/// boundary: straightest_outline(). up: rising_direction() of options.up, and where that is zero, as by wire. best: as
/// by wire.
///
/// options.grain_angle turns what is said of wires: +y lies so far to the right of the chain.
Eigen::Vector2d upright_direction(const Chart& chart, const Positions2& uv, const Options& options);

/// Turns a layout so that up becomes +y, with its lower-left corner at the origin.
void stand_upright(Positions2& uv, const Eigen::Vector2d& up);

/// Returns two vertices of an upright layout whose direction says how the chart is turned: with Orientation::wire the
/// ends of the chain that stands upright, if they are apart; else the lowest and the highest vertex of the outline, of
/// those at one height the leftmost, whatever the numbering of the mesh.
VertexPair upright_pair(const Chart& chart, const Positions2& uv, const Options& options);

}  // namespace wirewarp
