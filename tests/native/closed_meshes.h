// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces, and surfaces side by side.
#pragma once

#include <functional>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns a closed surface from pole to pole. shape: maps unit vectors to points. rises: returns whether the diagonal
/// of the cell (i, j), around and from pole to pole, goes up with i.
FlattenInput closed_surface(int around, int rings, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& shape,
                            const std::function<bool(int, int)>& rises);

/// Returns the surface of the unit cubes (i, j, k) of a grid for which is_solid(i, j, k) is true.
FlattenInput cubes(int nx, int ny, int nz, const std::function<bool(int, int, int)>& is_solid);

/// Returns both surfaces with their seams, the second one moved along x.
FlattenInput beside(FlattenInput first, const FlattenInput& second, double apart);

}  // namespace wirewarp::test
