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

#include "newton/refine_shape.h"

namespace wirewarp {

/// Exact lengths within the tolerances, with λ; none: not reached. map:
/// one row per chart vertex; injective, as limits say. Throws Stopped.
std::optional<RefinementStart> injective_start(const RefineTask& task, const Positions2& map,
                                               const RefinementLimits& limits);

}  // namespace wirewarp
