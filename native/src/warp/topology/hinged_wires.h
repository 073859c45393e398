// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "warp/topology/split_chart.h"

namespace wirewarp {

/// Extends every wire that ends inside the chart by a helper wire: straight to the first wire or boundary in its way
/// (paper III-A), or along the shortest path to another wire or boundary if the straight line winds around the surface.
/// Throws UnjoinedWires if there is no path.
void extend_hinged_wires(SplitChart& split, WorkMeter& work);

}  // namespace wirewarp
