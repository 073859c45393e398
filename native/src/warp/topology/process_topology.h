// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Prepares the wire network of a chart for Eq. (1) (paper III). Afterwards, no wire has the same region on both sides,
/// and every region has one loop around it. Returns nullopt if the network already has this form. Otherwise returns a
/// copy of the chart on the same surface:
/// - the first vertices and all wires and boundaries are the same as in the chart, with equal handles and positions;
/// - new vertices follow, with source_vertex -1; source_face of a divided face is the input face that contains it;
/// - helper wires follow the chart's wire parts: super-elastic, wire_index -1, parts counted from 0.
///
/// Throws UnjoinedWires if no network of this form is found, because rounding errors make a path impossible or
/// join_separate_loops() fails. Throws Stopped.
std::optional<Chart> process_topology(const Chart& chart, const StopToken& stop = {});

}  // namespace wirewarp
