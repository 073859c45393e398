// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "warp/inner/eq1.h"

namespace wirewarp {

/// Returns the unknowns of a KktSystem in elimination order: e for edge e, #edges + i for closure row i. Each closure
/// comes after its edges, because its diagonal entry is zero until then.
std::vector<int> order_elimination(const Eq1& eq1, const WireNetwork& network);

}  // namespace wirewarp
