// SPDX-License-Identifier: GPL-3.0-or-later
// Newton steps of minimize(): minima of a quadratic model of f + λᵀc on the linearized lengths.
#pragma once

#include "newton/newton_state.h"

namespace wirewarp {

/// Moves the start to exact lengths by a Newton step and a retraction. Far from the minimum, the step uses the
/// Laplacian as Hessian. Near the minimum, it uses the exact Hessian, or the convex part if the exact Hessian is not
/// positive. More steps with the same factor follow as long as they help. If the retraction fails near the minimum, a
/// second Newton step is tried. Returns rejected if lengths are not exact at the end. Throws Stopped.
StepOutcome reach_exact_lengths(NewtonState& state, bool is_near_minimum);

/// Takes a step with the exact Hessian that decreases f. Lengths are exact before and after the step. Near the minimum,
/// takes several steps with one factor. Returns rejected if the Hessian is not positive, or if f does not fall as
/// predicted.
StepOutcome take_newton_step(NewtonState& state);

}  // namespace wirewarp
