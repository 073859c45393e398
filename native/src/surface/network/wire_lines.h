// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary loops and wires as lines. A line continues through vertices at which other lines cross or meet it.
#pragma once

#include <vector>

#include "surface/network/wire_network.h"

namespace wirewarp {

/// One side of a line at a vertex through which the line continues.
struct LineBend {
  WireNode node;        // α: total angle of the sectors on this side; ℓ: mean ℓ of these sectors
  int num_sectors = 1;  // more than one if other lines cross or meet the line on this side
};

/// The lines of a network. Two wires that meet end to end are one line, unless more wires meet there.
struct WireLines {
  std::vector<LineBend> bends;    // one per inner vertex of a line, for each side inside the chart
  std::vector<WireNode> corners;  // the sectors between two lines, which are nodes of the network
};

WireLines find_lines(const Chart& chart, const WireNetwork& network);

}  // namespace wirewarp
