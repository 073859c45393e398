// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/coarsen/coarse_chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Places the fine wire vertices between coarse ones, in rows of uv: each run as it unrolls, bent so that runs that
/// meet turn with one another as they do on the surface, and stretched from one end to the other. However jagged a wire
/// is, its corners keep their angles.
void prolong_wires(const Chart& chart, const HeldNetwork& network, const CoarseChart& coarse,
                   const Positions2& coarse_uv, Positions2& uv);

}  // namespace wirewarp
