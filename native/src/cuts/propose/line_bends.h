// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "wirewarp/cut_mesh.h"

namespace wirewarp {

/// Returns for each line of a cut the number of vertices at which the line turns by more than 30 degrees on the
/// surface. Vertices where lines meet or end do not count.
std::vector<int> count_bends(const CutMesh& cut, std::size_t num_lines);

}  // namespace wirewarp
