// SPDX-License-Identifier: GPL-3.0-or-later
// Random input of flatten(): legal, with any topology and quality, or with one known fault.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "flatten.h"

namespace wirewarp::test {

struct RandomCase {
  FlattenInput input;
  InternalOptions options;
  std::optional<ErrorCode> fault;  // the error that must be thrown or that a piece must have; empty: the input is legal
  std::string description;
};

/// Returns the case of a seed, the same on every system.
RandomCase make_random_case(std::uint64_t seed);

}  // namespace wirewarp::test
