// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the coordinates of the points in the two directions of largest spread, one row per point. Points that are
/// near each other in space stay near each other. Use this layout before a flat shape exists.
Positions2 project_to_principal_plane(const Positions3& points);

}  // namespace wirewarp
