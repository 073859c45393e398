// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "newton/newton_system.h"

namespace wirewarp {

/// Moves uv to exact lengths by least changes in the metric of the current factor. Returns false, and does not change
/// uv, if uv is too far from the linearization or the caller stops.
bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv, const StopToken& stop = {});

}  // namespace wirewarp
