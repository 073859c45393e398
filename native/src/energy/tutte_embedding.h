// SPDX-License-Identifier: GPL-3.0-or-later
// The Tutte embedding of a chart in a circle, a start without flips: the outer loop is on the circle, all other
// vertices are inside.
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the layout, one row per chart vertex, scene units. The outer loop is mapped counter-clockwise to a circle of
/// the chart's 3D area, so that arcs are proportional to edge lengths. Every other vertex is at the weighted mean of
/// its neighbors. The weight of an edge is the sum of its two mean-value weights (warp/inner/mean_value.h). Weights are
/// positive and symmetric, so one Cholesky factorization is enough. A cone with one more vertex, its apex, fills each
/// hole. The filled chart is a triangulated disk, and its outline is a strictly convex polygon, so no triangle is
/// flipped (M. S. Floater, One-to-one piecewise linear mappings over triangulations, Mathematics of Computation 72
/// (2003), 685-696). Throws FactorizationFailed if rounding makes the matrix indefinite.
Positions2 tutte_embedding(const Chart& chart, const StopToken& stop = {});

}  // namespace wirewarp
