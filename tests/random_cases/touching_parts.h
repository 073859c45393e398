// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Moves one part of a legal mesh so that it touches another in a vertex, which both have from then on; a new wire
/// passes through it where no other wires are. False, with the input as it was, where the vertices drawn are of one
/// part.
bool let_parts_touch(RandomStream& random, FlattenInput& input);

}  // namespace wirewarp::test
