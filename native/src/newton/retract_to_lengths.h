// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "newton/newton_system.h"

namespace wirewarp {

/// Moves uv to exact lengths by chord steps with the current factor. Each step is the least change in the metric of the
/// factor, and must reduce the error by at least a tenth. If exact lengths are not reached, because uv is too far from
/// the linearization or the caller stops, returns false and does not change uv.
bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv, const StopToken& stop = {});

}  // namespace wirewarp
