// SPDX-License-Identifier: GPL-3.0-or-later
// Finds exact lengths without flipping a triangle. Starts from a flat shape that is injective and has wrong lengths,
// and uses the method of multipliers (M. J. D. Powell, A method for nonlinear constraints in minimization problems,
// 1969).
//
//   Φ(u, h) = f(u) + λᵀc + ½ cᵀρc,   |h| <= ε
//
//   c   length errors (energy/length_constraints.h)
//   ρ   stiffness of springs along the edges
//
// f is infinite for shapes that are not injective (energy/fair_shape_error.h). Newton steps with a convex Hessian
// minimize Φ, each so short that f stays finite; then λ += ρc. Lengths become exact as λ approaches the forces in the
// wires, so that no single step has to reach exact lengths.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Returns a shape with exact lengths, and λ; nullopt if exact lengths are not reached. Every shape on the way has the
/// injectivity of the stage. Throws Stopped (polled in the stages "start" and "shape") and FactorizationFailed.
///
/// map: first shape, one row per chart vertex. Default: the free ARAP map, or the Tutte embedding if the ARAP map is
/// not injective enough.
std::optional<Shape> injective_start(Problem& problem, const Stage& stage, const Control& control,
                                     std::optional<Positions2> map = {});

}  // namespace wirewarp
