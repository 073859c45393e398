// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns a legal sheet, tube or torus of a few quads, of any shape in space, without seams and wires.
FlattenInput small_mesh(RandomStream& random);

/// Removes, flips, splits, welds and adds a few faces: any topology, legal or not.
void change_faces(RandomStream& random, FlattenInput& input);

}  // namespace wirewarp::test
