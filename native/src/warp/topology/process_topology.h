// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Gives the wire network of a chart the shape Eq. (1) needs (paper III): no wire with the same region on both sides,
/// and one loop around every region. Empty if it has that shape already. Else a copy of the chart on the same surface:
/// - its first vertices and all wires and boundaries are the chart's own, same handles, same positions;
/// - new vertices follow, with source_vertex -1; source_face of a cut face is the input face it is a part of;
/// - helper wires follow the chart's wire parts: super-elastic, wire_index -1, parts counted from 0.
/// Throws UnjoinedWires where there is no such network: rounding spoils a path, or separate_loops.h has no way. Throws
/// Stopped.
std::optional<Chart> process_topology(const Chart& chart, const StopToken& stop = {});

}  // namespace wirewarp
