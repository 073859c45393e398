// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the chart with a numbering of vertices and faces that depends only on its shape. Loops over vertices and
/// faces then visit the same places in the same order, even if the input is renumbered, rotated or mirrored. If a
/// symmetric chart has several such numberings, the function chooses one. Vertices and faces keep their sources. The
/// wire index of a wire part becomes the part's index in the chart. Throws Stopped.
Chart in_canonical_order(const Chart& chart, const StopToken& stop);

}  // namespace wirewarp
