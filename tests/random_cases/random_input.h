// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns a legal mesh of one to three separate parts. Each part is a sheet, a sheet with holes, a rough sheet, a
/// tube, a ball, a ring, a fan or a single triangle. A part may have even or uneven faces, slivers, any size and any
/// place, with vertices and faces in any order. Appends words about the mesh to the description.
FlattenInput random_mesh(RandomStream& random, std::string& description);

/// Chooses two vertices of a legal mesh at random. If they belong to different parts, moves one part so that both
/// vertices coincide, and merges the vertices. Adds a wire through the merged vertex, unless other wires use one of its
/// two edges. Returns false, with the input unchanged, if both vertices belong to one part.
bool let_parts_touch(RandomStream& random, FlattenInput& input);

/// Adds a fabric that is stretched when worn to legal input of the refined method. May also add wires along seams, and
/// eases of wires and sides. Appends words about the changes to the description.
void add_random_stretch(RandomStream& random, FlattenInput& input, Options& options, std::string& description);

/// Adds one fault to a legal input, and returns the error that must result.
ErrorCode add_random_fault(RandomStream& random, FlattenInput& input, Options& options);

}  // namespace wirewarp::test
