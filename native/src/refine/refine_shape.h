// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method: all vertex positions at once, under exact lengths.
//
//   min f(u)   subject to   c(u, h) = 0,   |h| <= ε on elastic parts
//
// f is the shape error and the fairness of the wires (refine/fair_shape_error.h), c the lengths
// (refine/length_constraints.h). A Newton method on the feasible set: one step reaches exact lengths from a start near
// them, and from there every iterate has exact lengths, so that it can stop anywhere.
#pragma once

#include <utility>

#include "refine/fair_shape_error.h"
#include "refine/refine_budget.h"
#include "refine/refine_task.h"
#include "stop_token.h"
#include "wirewarp/types.h"

namespace wirewarp {

struct RefinedShape {
  Positions2 uv;                // one row per chart vertex, scene units
  Eigen::VectorXd variation;    // h, one per wire part of the chart; on super-elastic ones what came out
  Eigen::VectorXd multipliers;  // λ, one per edge of the network
  double objective = 0;         // f over the 3D area
  double length_error = 0;      // LengthConstraints::largest_error
  Injectivity injectivity = Injectivity::none;  // once make_injective() has looked
  int iterations = 0;
  int factorizations = 0;
  bool is_exact = false;   // the lengths are: uv is a flat shape to cut
  bool converged = false;  // another step promises less than 1e-9 of f, or than rounding makes of f
};

struct RefinementLimits {
  RefineBudget& budget;
  StopToken stop = {};                          // asked before each factorization
  Injectivity injectivity = Injectivity::none;  // of all iterates, the start included
};

/// Where to begin: far from the minimum, where lengths may be out by half, or with multipliers near it.
struct RefinementStart {
  RefinementStart(Positions2 positions, Eigen::VectorXd tensions = {})
      : uv(std::move(positions)), multipliers(std::move(tensions)) {}

  Positions2 uv;                // one row per chart vertex
  Eigen::VectorXd multipliers;  // λ, one per edge of the network; empty: not known
};

/// Not exact where the start is too far from exact lengths for one step, or the budget is spent
/// before that. Stopped with exact lengths: the shape at hand; before: throws Stopped. Where flips are not forbidden
/// and stay, it gives up.
RefinedShape refine_shape(const RefineTask& task, const RefinementStart& start, const RefinementLimits& limits);

/// The start as a shape: its f, and whether its lengths are exact. Converged where it is isometric.
RefinedShape evaluate_shape(const RefineTask& task, const RefinementStart& start);

}  // namespace wirewarp
