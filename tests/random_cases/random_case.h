// SPDX-License-Identifier: GPL-3.0-or-later
// Makes random input of flatten(), and judges the result. The input is valid or has one known fault.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flatten.h"

namespace wirewarp::test {

struct RandomCase {
  FlattenInput input;
  InternalOptions options;
  std::optional<ErrorCode> fault;  // expected error of the call or of a piece, empty for valid input
  std::string description;
};

/// Returns the case of a seed. The case is the same on every system.
RandomCase make_random_case(std::uint64_t seed);

using Counts = std::map<std::string, int>;

struct Outcome {
  std::string name;  // "flat", the code of an error, or "exception"
  std::vector<std::string> broken;
  Counts starts = {};  // number of pieces without an error, keyed by start

  void add(std::vector<std::string> sentences) {
    for (std::string& sentence : sentences) broken.push_back(std::move(sentence));
  }
};

/// Returns the verdict, and a sentence for each broken guarantee or missing error.
Outcome judge(const RandomCase& random_case);

}  // namespace wirewarp::test
