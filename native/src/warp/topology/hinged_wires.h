// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "warp/topology/split_chart.h"

namespace wirewarp {

/// Extends every wire that ends inside the chart by a helper wire, straight on until it meets a wire or a boundary
/// (paper III-A). Where straight on leads round the surface, the shortest path to another wire or boundary is taken.
/// Throws UnjoinedWires where there is none.
void extend_hinged_wires(SplitChart& refined, WorkMeter& work);

}  // namespace wirewarp
