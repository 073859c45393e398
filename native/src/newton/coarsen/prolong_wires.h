// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/coarsen/coarse_chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Places the fine wire vertices between the coarse wire vertices, in rows of uv. Each run is unrolled, bent so that
/// runs meet at the angles of the surface, and stretched to fit between its ends. Corners keep their angles even on
/// jagged wires.
void prolong_wires(const Chart& chart, const HeldNetwork& network, const CoarseChart& coarse,
                   const Positions2& coarse_uv, Positions2& uv);

}  // namespace wirewarp
