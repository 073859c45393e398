// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the flat shape of a coarse chart to a start for the fine chart.
#pragma once

#include "newton/coarsen/coarse_chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the flat positions of all vertices, one row each.
///
///   pᵢ, uᵢ   positions of coarse vertex i on the surface and in the plane
///   Jᵢ       mean derivative of the flat map around coarse vertex i
///   p, q     position of a fine vertex, and its place Σ bᵢ pᵢ on the coarse mesh
///
///   u(p) = Σ bᵢ [uᵢ + ½ Jᵢ (p − pᵢ)] + ½ (Σ bᵢ Jᵢ) (p − q)
///
/// u is exact for affine maps, and for quadratic maps if p = q and all Jᵢ are exact.
Positions2 interpolate(const Chart& chart, const CoarseChart& coarse, const Positions2& coarse_uv);

/// Returns a start for the fine chart, one row per vertex. Interpolates the positions, then places the wires by their
/// runs (prolong_wires.h) and unfolds flipped slivers.
Positions2 prolong_positions(const Chart& chart, const HeldNetwork& network, const CoarseChart& coarse,
                             const Positions2& coarse_uv);

/// Returns the multiplier of each fine wire edge, which is the multiplier of its coarse edge. A multiplier is a force
/// along the wire, so it does not depend on edge lengths.
Eigen::VectorXd prolong_multipliers(const CoarseChart& coarse, const Eigen::VectorXd& coarse_multipliers);

}  // namespace wirewarp
