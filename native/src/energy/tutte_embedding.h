// SPDX-License-Identifier: GPL-3.0-or-later
// The Tutte embedding of a chart in a circle, a start without flips. The outer loop is on the circle. Every other
// vertex is at a weighted mean of its neighbors. The weights are positive and symmetric: sums of the two mean-value
// weights of an edge (warp/inner/mean_value.h). Cones fill the holes. Then no triangle is flipped except by rounding
// errors (M. S. Floater, One-to-one piecewise linear mappings over triangulations, Mathematics of Computation 72
// (2003), 685-696).
#pragma once

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the layout, one row per chart vertex, scene units. The circle has the area of the chart in 3D, and its arcs
/// are proportional to edge lengths. Throws Stopped and FactorizationFailed.
Positions2 tutte_embedding(const Chart& chart, const StopToken& stop = {});

}  // namespace wirewarp
