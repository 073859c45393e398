// SPDX-License-Identifier: GPL-3.0-or-later
// Random input of flatten(): legal of every topology and quality, or with one fault of a known kind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "flatten.h"

namespace wirewarp::test {

struct RandomCase {
  FlattenInput input;
  InternalOptions options;
  std::optional<ErrorCode> fault;  // the error that must come, thrown or carried by a piece; none: the input is legal
  std::string description;
};

/// The same seed gives the same case everywhere.
RandomCase make_random_case(std::uint64_t seed);

}  // namespace wirewarp::test
