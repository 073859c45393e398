// SPDX-License-Identifier: GPL-3.0-or-later
// Runs: the fine wire edges that one coarse edge replaces.
//
// A run is unrolled into the plane with the mean turning of its two sides. The chord connects the ends of the unrolled
// run; the coarse edge is as long as the chord. The surface angles at the ends change by the angles between the chord
// and the end edges. The surface angles also change by the difference between the turning of a side and the mean,
// mostly at the nearer end.
#pragma once

#include <vector>

#include "surface/network/wire_network.h"

namespace wirewarp {

struct WireRun {
  std::vector<WireHalfEdge> half_edges;
  std::vector<double> headings;  // direction of each unrolled edge relative to the chord
  double walked_length = 0;
  double chord_length = 0;
  /// By how much each side turns more than the mean of both sides, at the first and at the last vertex.
  double one_sided[2] = {0, 0};
};

/// Returns the runs into which the kept vertices divide all wires. The runs are not unrolled yet. Wires may meet or end
/// only at kept vertices. stays: one flag per chart vertex, true if it is kept.
std::vector<WireRun> find_wire_runs(const Chart& chart, const WireNetwork& network, const std::vector<char>& stays);

/// Sets all fields of a run from its half-edges. node_at_arrival: result of nodes_at_arrival() for the network.
void unroll(const WireNetwork& network, const std::vector<int>& node_at_arrival, WireRun& run);

}  // namespace wirewarp
