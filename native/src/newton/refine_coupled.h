// SPDX-License-Identifier: GPL-3.0-or-later
// A coupled group: charts with elastic seams, whose sides have one length. All positions and lengths at once.
//
//   min Σ f_k(u_k)   subject to   c_k(u_k, h) = 0,   |h| <= ε       over the charts k, h shared by all sides of a seam
//
// It is the problem of refine_shape on the charts as one that is not connected, so its steps work: the Newton matrix
// falls into blocks, one a chart, and only the Schur complement of h, dense and small, couples them.
#pragma once

#include <vector>

#include "newton/refine_shape.h"

namespace wirewarp {

struct CoupledShapes {
  std::vector<RefinedShape> shapes;  // one per chart, without multipliers; factorizations: those of all charts, in each
  double projected_gradient = 0;     // PieceReport::projected_gradient
};

/// From starts near exact lengths; if no triangle may flip and none is flipped, they may be farther from them. Their
/// multipliers: one per edge of the chart's held network, then those of the grain rows; what is missing counts as 0.
/// cloths: one per chart, or none for no cloth. All shapes are exact, or none.
CoupledShapes refine_coupled(const std::vector<Chart>& charts, double fairness, const std::vector<ClothOnChart>& cloths,
                             const std::vector<RefinementStart>& starts, const RefinementLimits& limits);

}  // namespace wirewarp
