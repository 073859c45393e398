// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/types.h"

namespace wirewarp {

/// Points along the two directions in which they spread most: a layout that separates near points from far ones, before
/// there is a flat one.
Positions2 project_to_principal_plane(const Positions3& points);

}  // namespace wirewarp
