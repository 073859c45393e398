// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on a mesh that need not follow its edges.
#pragma once

#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

/// A line on a triangle mesh. Consecutive points are in the same triangle, and the line between them is straight.
struct SurfacePath {
  std::vector<int> faces;  // (k,) triangle that contains each point, inside or on its border
  Positions3 coordinates;  // (k, 3) barycentric coordinates in that triangle: weights of its corners
};

/// Throws FlattenError (invalid_option) if the path cannot be valid on any mesh.
void check_surface_path(const SurfacePath& path);

}  // namespace wirewarp
