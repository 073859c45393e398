// SPDX-License-Identifier: GPL-3.0-or-later
// Newton steps of minimize(): minima of a quadratic model of f + λᵀc on the linearized lengths.
#pragma once

#include "newton/newton_state.h"

namespace wirewarp {

/// Moves the start to exact lengths, or returns rejected. Near the minimum, steps use the exact or convex Hessian; far
/// from the minimum, the Laplacian. Throws Stopped.
StepOutcome reach_exact_lengths(NewtonState& state, bool is_near_minimum);

/// Takes a step with exact lengths that decreases f, and more steps with the same factor near the minimum. Returns
/// rejected if the Hessian is not positive, or if f does not fall as predicted.
StepOutcome take_newton_step(NewtonState& state);

}  // namespace wirewarp
