// SPDX-License-Identifier: GPL-3.0-or-later
// Rotates each piece upright and places all pieces side by side.
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Rotates each layout so that its upright_direction() is +y, mirrors it if requested, and places the pieces' bounding
/// boxes by Options::layout without overlap, with the lower-left corner at the origin.
///
/// layouts: one per chart, with one row per chart vertex in scene units; a layout without rows is skipped. options:
/// uses layout, orientation, grain, grain_angle, up, gap, mirror and cloth. Rotation and translation change each
/// coordinate by a few rounding errors. Throws Stopped.
std::vector<Positions2> pack_pieces(const std::vector<Chart>& charts, std::vector<Positions2> layouts,
                                    const Options& options, const StopToken& stop = {});

/// Returns the layout as seen from the other side, exactly: x is negated.
Positions2 mirror_image(const Positions2& uv);

}  // namespace wirewarp
