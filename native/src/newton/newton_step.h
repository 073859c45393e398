// SPDX-License-Identifier: GPL-3.0-or-later
// Newton steps of minimize(): minima of a quadratic model of f + λᵀc on the linearized lengths.
#pragma once

#include "newton/newton_state.h"

namespace wirewarp {

/// Moves the start to exact lengths: one Newton step and the way back from its end, with the Laplacian as Hessian. Near
/// the minimum with the exact Hessian, or its convex part where that is not positive; and a second step where the first
/// one is too long; from there on steps with the factor at hand, as far as they lead. Rejected where lengths are not
/// exact by then. Throws Stopped.
StepOutcome reach_exact_lengths(NewtonState& state, bool is_near_minimum);

/// From exact lengths to exact lengths, downhill, with the exact Hessian; near the minimum several steps with one
/// factor. Rejected where the Hessian is not positive, or the step does not go down as predicted.
StepOutcome take_newton_step(NewtonState& state);

}  // namespace wirewarp
