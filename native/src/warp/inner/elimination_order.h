// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "warp/inner/eq1.h"

namespace wirewarp {

/// Nested dissection of the unknowns of Eq. (1)'s optimality system. Returns the unknowns in the order of elimination:
/// edge e is unknown e, closure row i is unknown #edges + i.
///
/// First the edges between two crossings of wires, all but one: each fills in no more than its neighbors and the loops
/// on its two sides. Then the loops are dissected where they lie on the surface; loops that share an edge or a
/// wire-node are neighbors. An edge comes with the first of its loops. A closure comes after the last of its own edges:
/// no sooner, since its diagonal is zero until they are eliminated.
std::vector<int> order_elimination(const Eq1& eq1, const WireNetwork& network);

}  // namespace wirewarp
