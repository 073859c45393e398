// SPDX-License-Identifier: GPL-3.0-or-later
// A coupled group consists of charts with elastic seams, whose sides have one length. All positions and lengths are
// solved at once:
//
//   min Σ f_k(u_k)   subject to   c_k(u_k, h) = 0,   |h| <= ε       over the charts k, h shared by all sides of a seam
//
// This is the problem of minimize() for the charts as one chart that is not connected, so its steps work: the Newton
// matrix has one block for each chart, and only the Schur complement of h, dense and small, couples them.
#pragma once

#include <limits>
#include <vector>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

struct CoupledSolution {
  std::vector<Solution> charts;  // have no multipliers; each has the factorizations of the whole group
  // PieceReport::projected_gradient; NaN for one chart.
  double projected_gradient = std::numeric_limits<double>::quiet_NaN();
};

/// Minimizes from starts near exact lengths. The starts may be farther from exact lengths if the stage forbids flips
/// and they have none. Their multipliers: one per edge of the chart's held network, then one per grain row; missing
/// ones are 0. lengths: one per chart, or empty if charts are free to turn; those of the stage come from them. All
/// solutions are exact, or none.
CoupledSolution refine_coupled(const std::vector<const Chart*>& charts, double fairness, Stage stage,
                               const std::vector<TargetLengths>& lengths, const std::vector<Shape>& starts,
                               const Control& control);

}  // namespace wirewarp
