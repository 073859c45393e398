// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the flat shape of a coarse chart to a start for the fine chart.
#pragma once

#include "newton/coarsen/coarse_chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the positions of all vertices, one row each, from the positions of the coarse vertices: a vertex p = Σ bᵢ pᵢ
/// goes to
///
///   u(p) = Σ bᵢ [uᵢ + ½ Jᵢ (p − pᵢ)] + ½ (Σ bᵢ Jᵢ) (p − Σ bᵢ pᵢ)
///
/// with Jᵢ the mean derivative around coarse vertex i. This is exact for affine maps, and for quadratic maps if Jᵢ is
/// exact.
Positions2 interpolate(const Chart& chart, const CoarseChart& coarse, const Positions2& coarse_uv);

/// Returns a start for the fine chart, one row per vertex. Interpolates the positions, then places the wires by their
/// runs (prolong_wires.h) and unfolds flipped slivers.
Positions2 prolong_positions(const Chart& chart, const HeldNetwork& network, const CoarseChart& coarse,
                             const Positions2& coarse_uv);

/// Returns λ of each fine wire edge: the λ of its coarse edge, because λ is a force along the wire, independent of edge
/// lengths.
Eigen::VectorXd prolong_multipliers(const CoarseChart& coarse, const Eigen::VectorXd& coarse_multipliers);

}  // namespace wirewarp
