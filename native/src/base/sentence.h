// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of error sentences: wires, percentages, and lists that name a few elements and count the others.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Maximum number of elements or lengths that a sentence lists; readers skip longer lists.
inline constexpr std::size_t kMostNamed = 5;

/// Returns "a", "a and b", "a, b and c", or "a, b and 7 more" if count is larger than the number of names.
std::string listed(const std::vector<std::string>& names, std::size_t count);

/// Returns text such as "vertex 3", "vertices 3, 7 and 9" or "faces 1, 2, 3, 4, 5 and 12 more". noun: "vertex", "edge"
/// or "face".
std::string name_elements(const std::string& noun, const std::vector<int>& indices);

/// Returns text such as "edge 3-7" or "edges 3-7 and 7-9". Each edge is named by its two vertices.
std::string name_elements(const std::string& noun, const std::vector<VertexPair>& edges);

/// Returns text such as ", such as along edges 3-7 and 7-9"; "" without edges.
std::string such_as_along(const std::vector<VertexPair>& edges);

/// Returns text such as "wires 2 and 5"; a single wire gets its name if it has one: "wire 2 (waist)". names: one per
/// index, may be "".
std::string name_wires(const std::vector<int>& indices, const std::vector<std::string>& names);

/// Returns text such as "the piece around face 3". faces: input faces of the piece.
std::string name_piece(const std::vector<int>& faces);

/// Returns text such as "The piece around face 3 (12 triangles)".
std::string introduce_piece(const std::vector<int>& faces);

std::string capitalized(std::string sentence);

/// Returns the number with the fewest digits that identify it, such as "0.1", "1e-300" or "nan".
std::string shortest(double value);

/// Returns the number with three significant digits, such as "3.25" or "1.2e+06".
std::string rounded(double value);

/// Returns the absolute value of a fraction as a percentage, such as "3.25%".
std::string percent(double fraction);

}  // namespace wirewarp
