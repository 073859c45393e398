// SPDX-License-Identifier: GPL-3.0-or-later
// To exact lengths without turning a triangle over: from a flat shape that is injective and has wrong lengths, by the
// method of multipliers (M. J. D. Powell, A method for nonlinear constraints in minimization problems, 1969).
//
//   Φ(u, h) = f(u) + λᵀc + ½ cᵀρc,   |h| <= ε        f infinite where the injectivity is lost:
//   energy/fair_shape_error.h
//
// Φ is minimized by Newton steps with a convex Hessian, each so short that it stays inside; then λ += ρc. Lengths
// become exact as λ becomes the forces in the wires, so that no step ever has to reach them at any price.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Returns a shape with exact lengths, with h in the tolerances and with λ; none if it is not reached. map: one row per
/// chart vertex, with the injectivity of the stage. Throws Stopped.
std::optional<Shape> injective_start(const Problem& problem, const Stage& stage, const Positions2& map,
                                     const Control& control);

}  // namespace wirewarp
