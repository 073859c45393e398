// SPDX-License-Identifier: GPL-3.0-or-later
// Unfolds developable charts, which become flat without strain: sheets, cylinders, cones, folded sheets.
#pragma once

#include <optional>

#include "newton/solution.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the layout in which every triangle keeps its shape, one row per chart vertex, scene units. Returns nullopt
/// if the triangles do not fit together within mean strains of 1e-4.
std::optional<Shape> unfold(const Chart& chart);

}  // namespace wirewarp
