// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method: all vertex positions at once, under exact lengths.
//
//   min f(u)   subject to   c(u, h) = 0,   |h| <= ε on elastic parts
//
// f is the shape error and the fairness of the wires (energy/fair_shape_error.h), c the lengths
// (energy/length_constraints.h). A Newton method on the feasible set: one step reaches exact lengths from a start near
// them, and from there every iterate has exact lengths, so that it can stop anywhere.
#pragma once

#include <optional>
#include <utility>

#include "base/stop_token.h"
#include "energy/fair_shape_error.h"
#include "energy/refine_task.h"
#include "newton/refine_budget.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// How an attempt at a flat shape with exact lengths ended.
enum class ShapeStatus {
  infeasible,  // no exact lengths from this start, or the budget was spent before that
  singular,    // a matrix had no factor in double precision before lengths were exact
  cancelled,   // the caller stopped before lengths were exact
  stalled,     // exact lengths; another step could reduce f
  converged,   // exact lengths; another step is predicted to gain less than 1e-9 of f, or than rounding makes of f
};

struct RefinedShape {
  Positions2 uv;                           // one row per chart vertex, scene units
  Eigen::VectorXd variation;               // h, one per wire part of the chart; on super-elastic ones what came out
  Eigen::VectorXd multipliers;             // λ, one per edge of the network
  double objective = 0;                    // f over the 3D area
  double length_error = 0;                 // LengthConstraints::largest_error
  std::optional<Injectivity> injectivity;  // once it was computed
  int iterations = 0;
  int factorizations = 0;
  ShapeStatus status = ShapeStatus::infeasible;

  /// uv is a flat shape to cut.
  bool is_exact() const { return status >= ShapeStatus::stalled; }
  bool is_converged() const { return status == ShapeStatus::converged; }
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

/// Infeasible if the start is too far from exact lengths for one step, or if the budget is spent before that. If the
/// caller stops once lengths are exact, returns the shape at hand. Gives up if flips are not forbidden and stay.
RefinedShape refine_shape(const RefineTask& task, const RefinementStart& start, const RefinementLimits& limits);

/// The start as a shape: its f, and whether its lengths are exact. Converged where it is isometric.
RefinedShape evaluate_shape(const RefineTask& task, const RefinementStart& start);

}  // namespace wirewarp
