// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Moves one part of a legal mesh so that it touches another in a vertex, which both share then. A new wire passes
/// through it if no other wires are there. Returns false, with the input unchanged, if the drawn vertices are of one
/// part.
bool let_parts_touch(RandomStream& random, FlattenInput& input);

}  // namespace wirewarp::test
