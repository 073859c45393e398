// SPDX-License-Identifier: GPL-3.0-or-later
// Elements in a sentence: the first few by name, the rest by number; wires, and shares in percent.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Elements and lengths that a sentence names: longer lists are not read.
inline constexpr std::size_t kMostNamed = 5;

/// "a", "a and b", "a, b and c", or "a, b and 7 more" where they are the first of so many.
std::string listed(const std::vector<std::string>& names, std::size_t count);

/// "vertex 3", "vertices 3, 7 and 9", "faces 1, 2, 3, 4, 5 and 12 more". noun is "vertex", "edge" or "face".
std::string name_elements(const std::string& noun, const std::vector<int>& indices);

/// The same for edges given by their ends: "edge 3-7".
std::string name_elements(const std::string& noun, const std::vector<VertexPair>& edges);

/// ", such as along edges 3-7 and 7-9"; nothing for none.
std::string such_as_along(const std::vector<VertexPair>& edges);

/// "wires 2 and 5"; a single wire with its name if it has one: "wire 2 (waist)". names: one for each index, may be "".
std::string name_wires(const std::vector<int>& indices, const std::vector<std::string>& names);

/// "the piece around face 3", of the piece's input faces.
std::string name_piece(const std::vector<int>& faces);

/// "The piece around face 3 (12 triangles)".
std::string introduce_piece(const std::vector<int>& faces);

/// The sentence with a capital at its beginning.
std::string capitalized(std::string sentence);

/// The fewest digits that round back to this number: "0.1", "1e-300", "nan".
std::string shortest(double value);

/// Three digits: "3.25", "1.2e+06".
std::string rounded(double value);

/// "3.25%", without a sign.
std::string percent(double fraction);

}  // namespace wirewarp
