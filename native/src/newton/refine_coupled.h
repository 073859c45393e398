// SPDX-License-Identifier: GPL-3.0-or-later
// A coupled group consists of charts with elastic seams, whose sides have one length. All positions and lengths are
// solved at once:
//
//   min Σ f_k(u_k)   subject to   c_k(u_k, h) = 0,   |h| <= ε       over the charts k, h shared by all sides of a seam
//
// This is the problem of minimize() for the charts as one chart that is not connected, so its steps work: the Newton
// matrix has one block for each chart, and only the Schur complement of h, dense and small, couples them.
#pragma once

#include <vector>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// A chart of a coupled group.
struct CoupledChart {
  const Chart& chart;
  const TargetLengths* lengths;  // null: nominal lengths, and the layout is free to turn; the same for the whole group
  /// Near exact lengths, but perhaps farther if the stage forbids flips and the start has none. Its multipliers: one
  /// per edge of the chart's held network, then one per grain row; missing ones are 0.
  Shape start;
};

struct CoupledSolution {
  std::vector<Solution> charts;             // have no multipliers; each has the factorizations of the whole group
  double projected_gradient = kNoGradient;  // of the group; kNoGradient if it is one chart
};

/// Minimizes from the starts. stage: without lengths, which the charts have. All solutions are exact, or none.
CoupledSolution refine_coupled(const std::vector<CoupledChart>& charts, double fairness, const Stage& stage,
                               const Control& control);

}  // namespace wirewarp
