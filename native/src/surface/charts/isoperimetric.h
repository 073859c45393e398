// SPDX-License-Identifier: GPL-3.0-or-later
// An outline of exact lengths bounds the area inside it: at most L²/4π in the loop that lies around all others, where
// the piece does not overlap itself. What is missing of the area on the surface is distortion, whatever the wires do.
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the greatest length that eases and tolerances allow for a boundary loop, scene units.
double longest_length(const Chart& chart, const HalfEdgeChain& loop);

/// Returns p, the largest part of its area that a flat chart can have with its longest possible loop. Above 1: no
/// bound. 0: closed.
double isoperimetric_ratio(const Chart& chart);

/// The least E (Eq. 4) over the 3D area with this share of the area: 1 - 2p for p <= 1/4 (singular values that sum to
/// 1), then 2 (1 - sqrt p)^2 (both sqrt p); 0 from p = 1. It is that of the same map in all triangles, and no other has
/// less (Jensen): as a function of p it is convex.
double least_shape_error(double share);

/// Returns whether the flat chart may have far too little area.
bool is_outline_too_short(const Chart& chart);

}  // namespace wirewarp
