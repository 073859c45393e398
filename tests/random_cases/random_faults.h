// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Breaks a legal input in one way; returns the error that must come.
ErrorCode add_random_fault(RandomStream& random, FlattenInput& input, Options& options);

}  // namespace wirewarp::test
