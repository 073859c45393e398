// SPDX-License-Identifier: GPL-3.0-or-later
// Judges what flatten() returns by the promises alone, with none of the library's own measures.
#pragma once

#include <string>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Every broken promise of a result as a sentence; none: all are kept.
std::vector<std::string> broken_promises(const FlattenInput& input, const Options& options,
                                         const FlattenResult& result);

/// What is wrong with an error itself: no sentence, no elements, elements that the input does not have.
std::vector<std::string> faults_of_error(const FlattenError& error, const FlattenInput& input);

}  // namespace wirewarp::test
