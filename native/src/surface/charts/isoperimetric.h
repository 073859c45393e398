// SPDX-License-Identifier: GPL-3.0-or-later
// An outline of given length bounds the area inside it: the outer loop encloses at most L²/4π if the piece does not
// overlap itself. If the surface has more area, the rest is distortion, whatever the wires do.
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the largest length that eases and tolerances allow for a boundary loop, scene units.
double longest_length(const Chart& chart, const HalfEdgeChain& loop);

/// Returns p, the largest share of its area that a flat chart can have with its longest possible loop. Above 1: no
/// bound. 0: closed.
double isoperimetric_ratio(const Chart& chart);

/// Returns the least E (Eq. 4) over the 3D area of a map to this share p of the area: 1 - 2p for p <= 1/4 (the singular
/// values sum to 1), 2 (1 - sqrt p)^2 up to p = 1 (both are sqrt p), then 0. All triangles have the same map in the
/// optimum, because the function is convex in p (Jensen).
double least_shape_error(double share);

/// Whether the flat chart has far too little area, whatever its shape.
bool is_outline_too_short(const Chart& chart);

}  // namespace wirewarp
