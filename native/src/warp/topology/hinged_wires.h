// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "warp/topology/split_chart.h"

namespace wirewarp {

/// Extends every wire that ends inside the chart by a helper wire to another wire or boundary (paper III-A). Throws
/// UnjoinedWires if there is no path.
void extend_hinged_wires(SplitChart& split, WorkMeter& work);

}  // namespace wirewarp
