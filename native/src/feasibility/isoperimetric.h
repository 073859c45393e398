// SPDX-License-Identifier: GPL-3.0-or-later
// An outline of exact lengths bounds the area inside it: at most L²/4π in the loop that lies around all others, where
// the piece does not overlap itself. What is missing of the area on the surface is distortion, whatever the wires do.
#pragma once

#include "feasibility/piece_outlines.h"

namespace wirewarp {

/// p: the largest part of its area that a piece can have when flat, by its longest loop. Above 1: no bound. 0: closed.
double isoperimetric_ratio(const PieceOutline& piece);

/// The least E (Eq. 4) over the 3D area with this share of the area: 1 - 2p for p <= 1/4 (singular values that sum to
/// 1), then 2 (1 - sqrt p)^2 (both sqrt p); 0 from p = 1. It is that of the same map in all triangles, and no other has
/// less (Jensen): as a function of p it is convex.
double least_shape_error(double share);

/// The share below which a piece with so many loops is not flattened.
double required_share(std::size_t num_loops);

}  // namespace wirewarp
