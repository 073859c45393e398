// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "newton/newton_system.h"

namespace wirewarp {

/// Moves uv to exact lengths by chord steps with the factor at hand, each the least change in its metric, for as long
/// as each takes off a tenth of the error. False where lengths are not kept by then: uv, left as it was, is too far
/// from the linearization, or the caller stops.
bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv, const StopToken& stop = {});

}  // namespace wirewarp
