// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the chart with its vertices and faces numbered by its shape alone: loops over them visit the same places in
/// the same order, however the input is numbered, rotated or mirrored. A symmetric chart has several such numberings;
/// one of them is chosen. Vertices and faces keep their sources, and the index of a wire part becomes that of the
/// chart's own part. Throws Stopped.
Chart in_canonical_order(const Chart& chart, const StopToken& stop);

}  // namespace wirewarp
