// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary loops and wires as lines that run on through the places where others cross or meet them.
#pragma once

#include <vector>

#include "surface/network/wire_network.h"

namespace wirewarp {

/// One side of a line at a vertex where it continues.
struct LineBend {
  WireNode node;        // α over all sectors on this side, ℓ their mean
  int num_sectors = 1;  // more than one where others cross or meet the line on this side
};

/// Two wires that meet end to end, alone at their vertex, are one line.
struct WireLines {
  std::vector<LineBend> bends;    // of the sides that lie in the chart
  std::vector<WireNode> corners;  // the sectors between two lines: nodes of the network
};

WireLines find_lines(const Chart& chart, const WireNetwork& network);

}  // namespace wirewarp
