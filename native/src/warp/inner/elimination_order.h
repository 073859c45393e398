// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "warp/inner/eq1.h"

namespace wirewarp {

/// Returns the unknowns of Eq. (1)'s optimality system in elimination order, by nested dissection. Edge e is unknown e,
/// closure row i is unknown #edges + i.
///
/// On each line between two crossings of wires, all edges except one come first: eliminating such an edge fills in only
/// entries for its neighbors and for the loops on its two sides. Then the loops are dissected by their positions on the
/// surface; loops that share an edge or a wire-node are neighbors. Each remaining edge comes with the first of its
/// loops. A closure comes after its last edge, because its diagonal entry is zero until all its edges are eliminated.
std::vector<int> order_elimination(const Eq1& eq1, const WireNetwork& network);

}  // namespace wirewarp
