// SPDX-License-Identifier: GPL-3.0-or-later
// One surface given in another way.
#pragma once

#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// The same surface turned, mirrored and with its vertices and faces in another order. Their count must be no multiple
/// of 7.
FlattenInput disguised(const FlattenInput& input);

/// Edges of the surface as they are numbered there.
std::vector<VertexPair> disguised(const FlattenInput& input, const std::vector<VertexPair>& edges);

FlattenInput with_seams(FlattenInput input, const std::vector<VertexPair>& edges);

}  // namespace wirewarp::test
