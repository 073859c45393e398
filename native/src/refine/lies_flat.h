// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "refine/refine_chart.h"

namespace wirewarp {

/// The refined method finds a flat shape of the chart with every promise kept: lengths, no flips, no overlap. A trial,
/// for what is proposed: it gives up where a piece takes far longer than others do. go_on: as in refine_chart().
bool lies_flat(const Chart& chart, const Options& options, const GoOn& go_on, const Tuning& tuning);

}  // namespace wirewarp
