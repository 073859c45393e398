// SPDX-License-Identifier: GPL-3.0-or-later
// A first flat shape of a chart without any wires: its outer loop on a circle, all other vertices inside.
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Maps the outer loop at its own proportions to the circle of the chart's 3D area, counter-clockwise, and every other
/// vertex to the mean of its neighbors. Their weights are positive and the same from both ends of an edge, the sum of
/// the two mean-value weights (warp/inner/mean_value.h): near enough to those, and one Cholesky factorization solves
/// for all. Holes are free: each counts as filled by a cone, whose apex is one more such vertex. The filled chart is a
/// triangulated disk and its outline a strictly convex polygon, so no triangle is flipped (M. S. Floater, One-to-one
/// piecewise linear mappings over triangulations, Mathematics of Computation 72 (2003), 685-696). One row per chart
/// vertex, scene units. Throws FactorizationFailed if rounding leaves the springs unstable.
Positions2 tutte_embedding(const Chart& chart, const StopToken& stop = {});

}  // namespace wirewarp
