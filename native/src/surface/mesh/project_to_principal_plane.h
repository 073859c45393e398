// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the points in the two directions of largest spread: a layout in which near points are near each other, for
/// use before a flat shape exists.
Positions2 project_to_principal_plane(const Positions3& points);

}  // namespace wirewarp
