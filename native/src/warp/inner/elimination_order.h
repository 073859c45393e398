// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "warp/inner/eq1.h"

namespace wirewarp {

/// Returns the unknowns of Eq. (1)'s optimality system in elimination order, by nested dissection. Edge e is unknown e,
/// closure row i is unknown #edges + i.
///
/// On each line between two crossings of wires, all edges but one come first: eliminating one of them fills in entries
/// for its neighbors and the loops on its two sides only. Then the loops are dissected by their places on the surface;
/// loops that share an edge or a wire-node are neighbors. Each remaining edge comes with the first of its loops. A
/// closure comes after its last edge, because its diagonal is zero until all its edges are eliminated.
std::vector<int> order_elimination(const Eq1& eq1, const WireNetwork& network);

}  // namespace wirewarp
