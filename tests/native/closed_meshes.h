// SPDX-License-Identifier: GPL-3.0-or-later
// Makes closed surfaces, and puts two surfaces side by side.
#pragma once

#include <functional>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns a closed surface. Cell (i, j) is number i around the axis, in ring j from the south pole.
///
/// shape: maps unit vectors to points
/// rises: whether a cell's diagonal goes from (i, j) to (i + 1, j + 1)
FlattenInput closed_surface(int around, int rings, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& shape,
                            const std::function<bool(int, int)>& rises);

/// Returns the surface of the unit cubes (i, j, k) of a grid for which is_solid(i, j, k) is true.
FlattenInput cubes(int nx, int ny, int nz, const std::function<bool(int, int, int)>& is_solid);

/// Returns both surfaces with their seams in one input. The second surface is moved along x by `apart`.
FlattenInput beside(FlattenInput first, const FlattenInput& second, double apart);

}  // namespace wirewarp::test
