// SPDX-License-Identifier: GPL-3.0-or-later
// Flattens random input and judges the result.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "random_case.h"

namespace wirewarp::test {

using Counts = std::map<std::string, int>;

struct Outcome {
  std::string name;  // "flat", or the code of the error
  std::vector<std::string> broken;
  Counts starts = {};  // number of pieces without an error, by their start

  void add(std::vector<std::string> sentences) {
    for (std::string& sentence : sentences) broken.push_back(std::move(sentence));
  }
};

/// Returns the verdict, and a sentence for each broken guarantee or missing error.
Outcome judge(const RandomCase& random_case);

}  // namespace wirewarp::test
