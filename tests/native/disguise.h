// SPDX-License-Identifier: GPL-3.0-or-later
// One surface given in another way.
#pragma once

#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// The same surface turned, mirrored and with its vertices, faces and corners in another order: face f is the last but
/// f of the input, and its corners 0, 1 and 2 are those numbered 1, 0 and 2 there. The number of vertices must not be a
/// multiple of 7.
FlattenInput disguised(const FlattenInput& input);

/// Edges of the surface as they are numbered there.
std::vector<VertexPair> disguised(const FlattenInput& input, const std::vector<VertexPair>& edges);

FlattenInput with_seams(FlattenInput input, const std::vector<VertexPair>& edges);

}  // namespace wirewarp::test
