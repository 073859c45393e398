// SPDX-License-Identifier: GPL-3.0-or-later
// Elements in a sentence: the first few by name, the rest by number.
#pragma once

#include <string>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

/// "vertex 3", "vertices 3, 7 and 9", "faces 1, 2, 3, 4, 5 and 12 more". noun is "vertex", "edge", "face" or "wire".
std::string name_elements(const std::string& noun, const std::vector<int>& indices);

/// The same for edges given by their ends: "edge 3-7".
std::string name_elements(const std::string& noun, const std::vector<VertexPair>& edges);

}  // namespace wirewarp
