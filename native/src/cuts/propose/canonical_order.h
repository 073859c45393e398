// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the chart with a numbering that depends only on its shape. Vertices and faces keep their sources, but the
/// wire index of a wire part becomes the part's index in the chart. Throws Stopped.
Chart in_canonical_order(const Chart& chart, const StopToken& stop);

}  // namespace wirewarp
