// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "topology/wire_network.h"

namespace wirewarp {

/// Writes the positions of all network vertices into uv (one row per chart vertex, scene units): walks a spanning tree
/// of the wires, each edge with its heading and length. The tree takes the shortest edges first, so that what rounding
/// leaves of a loop's gap falls on the longest edge of the loop.
void lay_out_wires(const Chart& chart, const WireNetwork& network, const Eigen::VectorXd& headings,
                   const Eigen::VectorXd& lengths, Positions2& uv);

}  // namespace wirewarp
