// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the coordinates of the points in the two directions of largest spread, one row per point. Points near each
/// other stay near each other, which is enough for elimination orders.
Positions2 project_to_principal_plane(const Positions3& points);

}  // namespace wirewarp
