// SPDX-License-Identifier: GPL-3.0-or-later
// The length of the outline bounds the area of a flat piece: without overlaps, an outer loop of length L encloses at
// most L²/4π. If the surface has more area, the piece must be distorted, with or without wires.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns, for each boundary loop, the largest length that eases and tolerances allow, scene units.
std::vector<double> longest_lengths(const Chart& chart);

/// Returns p, the largest possible flat area divided by the 3D area. The outer loop is assumed to be the longest of all
/// loops, and as long as eases and tolerances allow. If p is above 1, the outline does not force any distortion. A
/// closed chart has p = 0.
double isoperimetric_ratio(const Chart& chart);

/// Returns the least E (Eq. 4), divided by the 3D area, of a map that reduces the area to the share p: 1 - 2p for p <=
/// 1/4, with singular values of sum 1; 2 (1 - sqrt p)^2 up to p = 1, with both singular values sqrt p; 0 above. The
/// function is convex in p, so the optimal map is the same for all triangles (Jensen).
double least_shape_error(double share);

/// Returns whether every flat shape of the chart would have far too little area.
bool is_outline_too_short(const Chart& chart);

}  // namespace wirewarp
