// SPDX-License-Identifier: GPL-3.0-or-later
// Makes copies of a surface with another position, orientation and numbering.
#pragma once

#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns the surface rotated, mirrored and renumbered. With F faces, face f is the input's face F - 1 - f with its
/// first two corners swapped. The number of vertices must not be a multiple of 7, because vertices are renumbered in
/// steps of 7.
FlattenInput disguised(const FlattenInput& input);

/// Returns these edges in the numbering of disguised().
std::vector<VertexPair> disguised(const FlattenInput& input, const std::vector<VertexPair>& edges);

FlattenInput with_seams(FlattenInput input, const std::vector<VertexPair>& edges);

}  // namespace wirewarp::test
