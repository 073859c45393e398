// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Places axis-parallel boxes without overlap, so that the box around them is nearly square. Throws Stopped.
///
/// - Returns the lower-left corners of the boxes, n by 2. The lowest and the leftmost coordinate are 0.
/// - sizes: n by 2, width and height, not negative. Their rounding errors do not change the result.
/// - gap: space between boxes, exact to 1e-6 √area of all boxes
Positions2 pack_boxes(const Positions2& sizes, double gap, const StopToken& stop = {});

/// Places boxes side by side from left to right in their order, all at y = 0. Returns their lower-left corners, n by 2.
Positions2 place_in_row(const Positions2& sizes, double gap);

}  // namespace wirewarp
