// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Makes legal input of the refined method one of a cloth that is worn stretched, with or without wires along its
/// seams, and eases of wires and sides. Adds to `description` what it is.
void add_random_stretch(RandomStream& random, FlattenInput& input, Options& options, std::string& description);

}  // namespace wirewarp::test
