// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// A legal mesh: one to three parts that touch nowhere yet, each a sheet, a sheet with holes, a rough sheet, a tube, a
/// ball, a ring, a fan or a single triangle; evenly or unevenly meshed, with slivers, of any size and anywhere, its
/// vertices and faces in any order. Adds to `description` what it is.
FlattenInput random_mesh(RandomStream& random, std::string& description);

}  // namespace wirewarp::test
