// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Adds one fault to a legal input, and returns the error that must result.
ErrorCode add_random_fault(RandomStream& random, FlattenInput& input, Options& options);

}  // namespace wirewarp::test
