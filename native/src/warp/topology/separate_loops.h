// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/network/wire_network.h"
#include "warp/topology/split_chart.h"

namespace wirewarp {

/// A closed walk along one side of wires and boundaries, without the wires that have its region on both sides.
struct WireLoop {
  std::vector<VertexHandle> vertices;
  std::vector<double> position;  // of each vertex along the loop, scene units
  double length = 0;
  std::vector<VertexHandle> joints;  // where a wire with the region on both sides leaves the loop
};

/// The loops around one region where there are several, empty if there is no such region: what Eq. (1) needs. The
/// network has no tails.
std::vector<WireLoop> find_separate_loops(const WireNetwork& network);

/// Joins loops by helper wires until every region has one loop alone. Each loop gets four: the shortest path to
/// another loop, unless one wire joins it already, then those from the vertex farthest along the loop and from the two
/// halfway between (paper III-B). Throws UnjoinedWires where loops form a ring with one region on both sides, or no
/// path joins them.
void join_separate_loops(SplitChart& refined, WorkMeter& work);

}  // namespace wirewarp
