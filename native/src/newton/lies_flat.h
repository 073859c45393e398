// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/refine_chart.h"

namespace wirewarp {

/// Returns whether the refined method finds a flat shape of the chart with exact lengths, without flips and overlaps.
/// Returns false for pieces that take far longer than most, and if the caller stops.
bool lies_flat(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

}  // namespace wirewarp
