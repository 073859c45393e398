// SPDX-License-Identifier: GPL-3.0-or-later
// Newton steps of minimize(): minima of a quadratic model of f + λᵀc on the linearized lengths.
#pragma once

#include "newton/newton_state.h"

namespace wirewarp {

/// Moves the start to exact lengths by one Newton step and a retraction. Far from the minimum, the step uses the
/// Laplacian as Hessian. Near the minimum, it uses the exact Hessian or, if that is not positive, its convex part; a
/// second step follows if the first is too long, and then steps with the same factor as long as they help. Rejected if
/// lengths are not exact at the end. Throws Stopped.
StepOutcome reach_exact_lengths(NewtonState& state, bool is_near_minimum);

/// Takes a step that decreases f from exact lengths to exact lengths, with the exact Hessian; near the minimum, several
/// steps with one factor. Rejected if the Hessian is not positive, or if f does not fall as predicted.
StepOutcome take_newton_step(NewtonState& state);

}  // namespace wirewarp
