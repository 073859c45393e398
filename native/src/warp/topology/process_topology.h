// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Prepares the wire network of a chart for Eq. (1) (paper III). Returns nullopt if the network needs no change.
///
/// Afterwards, no wire has the same region on both sides, and every region has one loop around it. The result is a copy
/// of the chart on the same surface:
///
/// - The first vertices and all wires and boundaries have the same handles and positions as in the chart.
/// - New vertices follow, with source_vertex -1. source_face of a divided face is the input face that contains it.
/// - Helper wires follow the chart's wire parts. They are super-elastic, with wire_index -1 and part 0, 1, 2, ...
///
/// Throws Stopped, and UnjoinedWires if no such network is found.
std::optional<Chart> process_topology(const Chart& chart, const StopToken& stop = {});

}  // namespace wirewarp
