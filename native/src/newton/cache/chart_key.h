// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of charts: equal keys mean equal solutions. A key contains all bytes instead of a digest, so that keys cannot
// collide.
#pragma once

#include <string>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns everything that the flat shapes of a coupled group depend on, bit for bit: meshes, outlines, slits, wire
/// parts, which of these share a length, and the options of the solver. The key uses the numbering within each chart,
/// so that changes elsewhere in the input do not change the key. Errors also depend on name_key().
std::string solution_key(const std::vector<const Chart*>& group, const Options& options);

/// Returns the input's numbers and names of the charts' vertices, faces and wires.
std::string name_key(const std::vector<const Chart*>& group, const std::vector<Wire>& wires);

}  // namespace wirewarp
