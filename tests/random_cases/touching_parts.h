// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Moves one part of a legal mesh so that it touches another part, and makes both share a vertex there. Adds a wire
/// through this vertex unless other wires are there. Returns false, with the input unchanged, if the two random
/// vertices belong to one part.
bool let_parts_touch(RandomStream& random, FlattenInput& input);

}  // namespace wirewarp::test
