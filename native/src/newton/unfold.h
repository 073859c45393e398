// SPDX-License-Identifier: GPL-3.0-or-later
// Charts that lie flat without strain: sheets, cylinders, cones, whatever is folded from one plane.
#pragma once

#include <optional>

#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// The layout that keeps every triangle, one row per chart vertex, scene units; none where the triangles leave gaps:
/// strains of 1e-4 in the mean. Each is laid beside one that is there already, across the longest edges there are: what
/// an edge rounds off is multiplied by what lies behind it over its length.
std::optional<Positions2> unfold(const Chart& chart);

}  // namespace wirewarp
