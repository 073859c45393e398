// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "inner/eq1.h"

namespace wirewarp {

/// Nested dissection of the unknowns of Eq. (1)'s optimality system. Returns the unknowns in the order of elimination:
/// edge e is unknown e, closure row i is unknown #edges + i.
///
/// The wires are halved again and again where they lie on the surface; the edges that join the halves come after both.
/// A closure comes right after the last of its own edges: no sooner, since its diagonal is zero until they are
/// eliminated, and no later, so that fill stays near the separators, whatever the number of wire-patches.
std::vector<int> order_elimination(const Eq1& eq1, const WireNetwork& network);

}  // namespace wirewarp
