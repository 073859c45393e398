// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

using Edge = VertexPair;  // the smaller vertex first

inline Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Adds random seams, or sometimes no seams. Seams are walks along edges, shortest paths between borders, or small
/// darts, slits and loops.
void add_random_seams(RandomStream& random, FlattenInput& input, std::string& description);

/// Adds random wires of every kind, sometimes many. Wires are walks or shortest paths along edges without a wire. They
/// may be closed, and may run along seams and outlines.
void add_random_wires(RandomStream& random, FlattenInput& input, std::string& description);

}  // namespace wirewarp::test
