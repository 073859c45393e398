// SPDX-License-Identifier: GPL-3.0-or-later
// Rotates each piece upright and places all pieces side by side.
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Turns layouts upright, unless a fabric is given, because they are upright then. Mirrors them if requested, and
/// places them by Options::layout, from the origin on. layouts: one row per chart vertex, scene units; skipped if
/// empty. Throws Stopped.
std::vector<Positions2> pack_pieces(const std::vector<Chart>& charts, std::vector<Positions2> layouts,
                                    const Options& options, const StopToken& stop = {});

/// Returns the layout as seen from the other side, exactly: x is negated.
Positions2 mirror_image(const Positions2& uv);

}  // namespace wirewarp
