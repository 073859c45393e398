// SPDX-License-Identifier: GPL-3.0-or-later
// Coupled groups: charts with common elastic seams. The sides of a seam have one length. All positions and lengths are
// solved at once:
//
//   min Σ f_k(u_k)   subject to   c_k(u_k, h) = 0,   |h| <= ε       over the charts k, h shared by all sides of a seam
//
// This is the problem of minimize() for one chart that is not connected. The Newton matrix has one block per chart, and
// only the Schur complement of h, which is dense and small, couples the blocks.
#pragma once

#include <vector>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

struct CoupledChart {
  const Chart& chart;
  const TargetLengths* lengths;  // null: nominal lengths and free rotation of the layout; null for all charts or none
  /// Must be near exact lengths, except if the stage forbids flips and the start has no flips. Its multipliers: one per
  /// edge of the chart's held network, then one per grain row; missing multipliers are 0.
  Shape start;
};

/// Returns a solution without multipliers for each chart; either all or none are exact. stage: must not have lengths,
/// because each chart has its own lengths.
std::vector<Solution> refine_coupled(const std::vector<CoupledChart>& charts, double fairness, const Stage& stage,
                                     const Control& control);

}  // namespace wirewarp
