// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of charts: equal keys mean equal solutions. A key contains all bytes instead of a digest, so that keys cannot
// collide.
#pragma once

#include <string>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns a key of everything that the flat shapes of a coupled group depend on, except the fabric's stretch. Changes
/// elsewhere in the input do not change the key. Errors also depend on name_key().
std::string solution_key(const std::vector<const Chart*>& group, const Options& options);

/// Returns a key of the input indices of the charts' vertices, faces and wires, and of the names of the wires.
std::string name_key(const std::vector<const Chart*>& group, const std::vector<Wire>& wires);

}  // namespace wirewarp
