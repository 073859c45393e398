// SPDX-License-Identifier: GPL-3.0-or-later
// Unfolds charts that are flat without strain: sheets, cylinders, cones, and others folded from one plane.
#pragma once

#include <optional>

#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the layout in which every triangle keeps its shape, one row per chart vertex, scene units. None if the
/// triangles do not fit together within mean strains of 1e-4. Each triangle is laid beside one that has its place,
/// across the longest edge available, because the rounding error of an edge grows with the size of the faces beyond it
/// over its length.
std::optional<Positions2> unfold(const Chart& chart);

}  // namespace wirewarp
