// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Adds a fabric that is stretched when worn to legal input of the refined method, with or without wires along seams,
/// and with eases of wires and sides. Appends a description.
void add_random_stretch(RandomStream& random, FlattenInput& input, Options& options, std::string& description);

}  // namespace wirewarp::test
