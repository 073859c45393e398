// SPDX-License-Identifier: GPL-3.0-or-later
// The length of the outline bounds the area of a flat piece: without overlaps, an outer loop of length L encloses at
// most L²/4π. If the surface has more area, the piece must be distorted, with or without wires.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns, for each boundary loop, the largest length that eases and tolerances allow, scene units.
std::vector<double> longest_lengths(const Chart& chart);

/// Returns p, the largest possible flat area divided by the 3D area; 0 for a closed chart. The outer loop has the
/// largest of longest_lengths(). If p is above 1, the outline forces no distortion.
double isoperimetric_ratio(const Chart& chart);

/// Returns the least E (Eq. 4), divided by the 3D area, of maps that reduce the area to the share p. The function is
/// convex in p, so the best map is the same for all triangles.
///
/// - p <= 1/4: 1 - 2p, with singular values of sum 1
/// - p <= 1: 2 (1 - sqrt p)^2, with both singular values sqrt p
/// - p > 1: 0
double least_shape_error(double share);

/// Returns whether every flat shape of the chart would have far too little area.
bool is_outline_too_short(const Chart& chart);

}  // namespace wirewarp
