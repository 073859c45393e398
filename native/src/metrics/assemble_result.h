// SPDX-License-Identifier: GPL-3.0-or-later
// From layouts to the result: pieces measured, promises checked, seams and wires reported.
#pragma once

#include <optional>
#include <vector>

#include "metrics/helper_wires.h"
#include "network/wire_network.h"
#include "stop_token.h"

namespace wirewarp {

/// A chart's planar shape and how it came about.
struct Layout {
  std::optional<WireNetwork> network;  // set where uv is
  Positions2 uv;  // one row per chart vertex, then those that helper wires need; scene units; no rows: no layout
  std::vector<double> variation;  // h, one per wire part of the chart
  std::vector<PlacedHelperWire> helper_wires;
  PieceReport report;
  std::vector<VertexPair> proposed_seams;  // of a layout that is turned over or covers itself
  std::optional<FlattenError> error;       // why there is no layout
};

/// Measures every layout. mirror: the layouts are handed over mirrored, and measured as seen from outside. Throws
/// Stopped.
FlattenResult assemble_result(const FlattenInput& input, const Charts& charts, std::vector<Layout> layouts, bool mirror,
                              const StopToken& stop = {});

}  // namespace wirewarp
