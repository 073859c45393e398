// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "refine/newton_system.h"

namespace wirewarp {

/// Moves uv to exact lengths, |c| <= 1e-13 l, by chord steps with the factor at hand: each is the least change in its
/// metric. False where a step does not halve the error: then uv, left as it was, is too far from the linearization.
bool restore_lengths(const LengthConstraints& constraints, const NewtonSystem& system, const Eigen::VectorXd& variation,
                     Positions2& uv);

}  // namespace wirewarp
