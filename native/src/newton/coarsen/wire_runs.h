// SPDX-License-Identifier: GPL-3.0-or-later
// Runs: the fine wire edges that one coarse edge replaces.
//
// A run is unrolled into the plane with the mean turning of its two sides. The coarse edge has the length of the chord,
// which connects the ends of the unrolled run. The angles between the chord and the end edges change the surface angles
// there. So does the turning of each side beyond the mean, mostly at the nearer end.
#pragma once

#include <vector>

#include "surface/network/wire_network.h"

namespace wirewarp {

struct WireRun {
  std::vector<WireHalfEdge> half_edges;
  std::vector<double> headings;  // of each edge, unrolled, relative to the chord
  double walked_length = 0;      // sum of the edges
  double chord_length = 0;
  double one_sided[2] = {0, 0};  // turning beyond the mean of both sides, for the first and last vertex
};

/// Divides all wires into runs at the vertices that stay, one flag per chart vertex. Wires must not meet or end at
/// other vertices. The runs are not unrolled yet.
std::vector<WireRun> find_wire_runs(const Chart& chart, const WireNetwork& network, const std::vector<char>& stays);

/// Fills in all but the half-edges. node_at_arrival: of the network.
void unroll(const WireNetwork& network, const std::vector<int>& node_at_arrival, WireRun& run);

}  // namespace wirewarp
