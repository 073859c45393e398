// SPDX-License-Identifier: GPL-3.0-or-later
// Turns each piece upright and lays all of them side by side.
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Turns each layout (rotation only) so that its upright_direction() is +y, mirrors it if asked, and lays the pieces'
/// bounding boxes out as Options::layout says, without overlap, the lower-left corner at the origin.
///
/// layouts: one per chart, one row per chart vertex, scene units; no rows: no layout, skipped. options: layout,
/// orientation, grain, up, gap and mirror. Rotation and translation move each coordinate by a few units of rounding.
/// Throws Stopped.
std::vector<Positions2> pack_pieces(const std::vector<Chart>& charts, std::vector<Positions2> layouts,
                                    const Options& options, const StopToken& stop = {});

/// The same layout seen from the other side, exactly: x negated.
Positions2 mirror_image(const Positions2& uv);

}  // namespace wirewarp
