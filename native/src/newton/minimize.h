// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method: all vertex positions at once, under exact lengths.
//
//   min f(u)   subject to   c(u, h) = 0,   |h| <= ε on elastic parts
//
// f is the shape error and the fairness of the wires (energy/fair_shape_error.h), c the lengths
// (energy/length_constraints.h). A Newton method on the feasible set: one step reaches exact lengths from a start near
// them, and from there every iterate has exact lengths, so that it can stop anywhere.
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Minimizes f from a start. If it has multipliers, it is near the minimum; otherwise lengths may be out by half.
/// Infeasible if the start is too far from exact lengths for one step, or if the budget is spent before that. Once
/// lengths are exact, the shape at hand is returned if the caller stops. Gives up on flips that are not forbidden and
/// do not open.
Solution minimize(const Problem& problem, const Stage& stage, const Shape& start, const Control& control);

/// Returns the shape with its f and length error, without a step and without what a stage forbids. Converged if the
/// shape is isometric.
Solution evaluate(const Problem& problem, const Stage& stage, const Shape& shape);

}  // namespace wirewarp
