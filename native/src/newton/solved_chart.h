// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "surface/network/wire_network.h"
#include "warp/outer/helper_wires.h"

namespace wirewarp {

/// The flat shape of a chart, or the error that explains why there is none.
struct SolvedChart {
  std::optional<WireNetwork> network;  // set if uv is not empty
  Positions2 uv;  // one row per chart vertex, then one per vertex of helper wires; scene units; empty: no layout
  std::vector<double> variation;  // h, one per wire part of the chart
  Eigen::VectorXd multipliers;    // λ of the refined method, one per held edge
  std::vector<PlacedHelperWire> helper_wires;
  PieceReport report;
  std::vector<VertexPair> proposed_seams;  // seams that fix a flipped or overlapping layout
  std::optional<FlattenError> error;       // why there is no layout
};

}  // namespace wirewarp
