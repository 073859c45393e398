// SPDX-License-Identifier: GPL-3.0-or-later
// Charts beside seams that give, whose sides have one length: all their positions and lengths at once.
//
//   min Σ f_k(u_k)   subject to   c_k(u_k, h) = 0,   |h| <= ε       over the charts k, h shared by all sides of a seam
//
// It is the problem of refine_shape on the charts as one that is not connected, so its steps serve: the Newton matrix
// falls into blocks, one a chart, and only the Schur complement of h, dense and small, couples them.
#pragma once

#include <vector>

#include "refine/refine_shape.h"

namespace wirewarp {

struct JoinedShapes {
  std::vector<RefinedShape> shapes;  // one per chart, without multipliers; the first tells the factorizations of all
  double projected_gradient = 0;     // PieceReport::projected_gradient
};

/// From starts near exact lengths; where no triangle may turn over and none is, they may be farther from them. Their
/// multipliers: one per edge of the chart's held network, then those of the grain rows; what is missing counts as 0.
/// cloths: one per chart, or none for no cloth. All shapes are exact, or none.
JoinedShapes refine_together(const std::vector<Chart>& charts, double fairness, const std::vector<ClothOnChart>& cloths,
                             const std::vector<RefinementStart>& starts, const RefinementLimits& limits);

}  // namespace wirewarp
