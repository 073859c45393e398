// SPDX-License-Identifier: GPL-3.0-or-later
// The Tutte embedding of a chart in a circle, a start without flips: the outer loop is on the circle, all other
// vertices are inside.
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Maps the outer loop, with its own proportions, to a circle of the chart's 3D area, counter-clockwise, and every
/// other vertex to the weighted mean of its neighbors. The weights are positive and symmetric: the sum of the two
/// mean-value weights of an edge (warp/inner/mean_value.h), so one Cholesky factorization is enough. A cone with one
/// more vertex, its apex, fills each hole. The filled chart is a triangulated disk, and its outline is a strictly
/// convex polygon, so no triangle is flipped (M. S. Floater, One-to-one piecewise linear mappings over triangulations,
/// Mathematics of Computation 72 (2003), 685-696). Returns one row per chart vertex, scene units. Throws
/// FactorizationFailed if rounding makes the matrix indefinite.
Positions2 tutte_embedding(const Chart& chart, const StopToken& stop = {});

}  // namespace wirewarp
