// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method solves for all vertex positions at once, under exact lengths:
//
//   min f(u)   subject to   c(u, h) = 0,   |h| <= ε on elastic parts
//
// f is the shape error and the fairness of the wires (energy/fair_shape_error.h). c: the length errors
// (energy/length_constraints.h). minimize() is a Newton method on the feasible set. Its first step reaches exact
// lengths from a start near them. Every later iterate has exact lengths, so minimize() can stop at any time.
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Minimizes f from a start. A start with multipliers must be near the minimum. The lengths of other starts may be
/// wrong by up to 50%.
///
/// - If the first step does not reach exact lengths, the result is infeasible.
/// - If the caller stops later, the result is the current shape.
/// - Ends early if triangles are still flipped after NewtonConstants::patience factorizations.
Solution minimize(const Problem& problem, const Stage& stage, const Shape& start, const Control& control);

/// Returns the shape with its f and length error. Takes no step, and does not check the injectivity that the stage
/// requires. The solution is converged if the shape is isometric.
Solution evaluate(const Problem& problem, const Stage& stage, const Shape& shape);

}  // namespace wirewarp
