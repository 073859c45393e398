// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/refine_chart.h"

namespace wirewarp {

/// The refined method finds a flat shape of the chart with all guarantees: lengths, no flips, no overlap. A trial,
/// for what is proposed: it gives up where a piece takes far longer than others do, or where it is stopped.
bool lies_flat(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

}  // namespace wirewarp
