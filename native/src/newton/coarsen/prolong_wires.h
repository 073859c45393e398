// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/coarsen/coarse_chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Sets the rows of uv for fine vertices of wires. Each run is unrolled, bent to the surface angles at its ends, and
/// scaled to fit. Corners keep their angles even on jagged wires.
void prolong_wires(const Chart& chart, const HeldNetwork& network, const CoarseChart& coarse,
                   const Positions2& coarse_uv, Positions2& uv);

}  // namespace wirewarp
