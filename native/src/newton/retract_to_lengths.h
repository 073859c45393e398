// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/stop_token.h"
#include "newton/newton_system.h"

namespace wirewarp {

/// Moves uv to exact lengths by chord steps with the current factor. Each step is the least change in the metric of the
/// factor and must reduce the error by a tenth. Returns false and leaves uv unchanged if lengths are not exact at the
/// end, because uv is too far from the linearization or the caller stops.
bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv, const StopToken& stop = {});

}  // namespace wirewarp
