// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/network/wire_network.h"
#include "warp/topology/split_chart.h"

namespace wirewarp {

/// A closed walk along one side of wires and boundaries. It omits wires that have the walk's region on both sides.
struct WireLoop {
  std::vector<VertexHandle> vertices;
  std::vector<double> position;  // arc length at each vertex, scene units
  double length = 0;
  std::vector<VertexHandle> joints;  // vertices where a wire with the loop's region on both sides leaves the loop
};

/// Returns the loops of a region with several loops; empty if each region has one loop, as Eq. (1) needs. The network
/// must have no tails.
std::vector<WireLoop> find_separate_loops(const WireNetwork& network);

/// Joins loops by helper wires until every region has exactly one loop (paper III-B). Throws UnjoinedWires if no path
/// joins loops, or if loops form a ring with the same region on both sides.
void join_separate_loops(SplitChart& split, WorkMeter& work);

}  // namespace wirewarp
