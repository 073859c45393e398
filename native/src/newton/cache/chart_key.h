// SPDX-License-Identifier: GPL-3.0-or-later
// A key that two charts share if and only if they have the same solution. It contains all bytes instead of a digest, so
// that there are no collisions.
#pragma once

#include <string>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns everything that the solutions of a coupled group without errors depend on, bit for bit: meshes, outlines,
/// slits, wire parts, which of these share a length, and the options of the solver. The charts' own numbering makes it
/// independent of changes elsewhere in the input. Only the names in errors are missing, see name_key().
std::string solution_key(const std::vector<const Chart*>& group, const Options& options);

/// Returns the input's numbers and names of the charts' vertices, faces and wires.
std::string name_key(const std::vector<const Chart*>& group, const std::vector<Wire>& wires);

}  // namespace wirewarp
