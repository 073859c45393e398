// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the points in the two directions of largest spread: a layout that separates near from far points before a
/// flat one exists.
Positions2 project_to_principal_plane(const Positions3& points);

}  // namespace wirewarp
