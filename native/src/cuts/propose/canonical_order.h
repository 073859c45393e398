// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// The chart with its vertices and faces numbered by its shape alone: however the input is numbered, turned or
/// mirrored, a loop over them visits the same places in the same order. A symmetric chart has several such numberings,
/// of which this is one. Vertices and faces keep their sources; a wire part's index is that of the chart's own part.
/// Throws Stopped.
Chart in_canonical_order(const Chart& chart, const StopToken& stop);

}  // namespace wirewarp
