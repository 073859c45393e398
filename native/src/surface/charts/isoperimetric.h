// SPDX-License-Identifier: GPL-3.0-or-later
// The length of the outline bounds the area of a flat piece: without overlaps, an outer loop of length L encloses at
// most L²/4π. If the surface has more area, the piece must be distorted, whatever its wires.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the largest length that eases and tolerances allow for each boundary loop, scene units.
std::vector<double> longest_lengths(const Chart& chart);

/// Returns p, the largest possible flat area over the 3D area, with the longest outer loop that eases and tolerances
/// allow. A value above 1 means that there is no bound; 0 means a closed chart.
double isoperimetric_ratio(const Chart& chart);

/// Returns the least E (Eq. 4) over the 3D area of a map that reduces the area to the share p: 1 - 2p for p <= 1/4,
/// with singular values of sum 1; 2 (1 - sqrt p)^2 up to p = 1, with both singular values sqrt p; 0 above. The function
/// is convex in p, so the optimal map is the same for all triangles (Jensen).
double least_shape_error(double share);

/// Returns whether every flat shape of the chart would have far too little area.
bool is_outline_too_short(const Chart& chart);

}  // namespace wirewarp
