// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns a legal mesh of one to three separate parts. Each is a sheet, a sheet with holes, a rough sheet, a tube, a
/// ball, a ring, a fan or a single triangle. A part may have even or uneven faces, slivers, any size and any place,
/// with vertices and faces in any order. Appends a description.
FlattenInput random_mesh(RandomStream& random, std::string& description);

}  // namespace wirewarp::test
