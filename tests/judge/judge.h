// SPDX-License-Identifier: GPL-3.0-or-later
// Judges what flatten() returns by the promises alone, with none of the library's own measures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Every broken promise of a result as a sentence; none: all are kept. unstretched: of a cloth that is worn stretched,
/// what it is without; null of any other.
std::vector<std::string> broken_promises(const FlattenInput& input, const Options& options, const FlattenResult& result,
                                         const FlattenResult* unstretched = nullptr);

/// What a piece of legal input may expect beyond the promises, as sentences: one that unfolds is found flat, and none
/// fails for reasons of the solver's own. fault: the one error that the input was given.
std::vector<std::string> broken_demands(const FlattenInput& input, const Options& options, const FlattenResult& result,
                                        const std::optional<ErrorCode>& fault,
                                        const FlattenResult* unstretched = nullptr);

/// How the shapes of a result differ from those of another that was laid out in another way alone.
std::vector<std::string> differences_of_layout(const FlattenInput& input, const Options& options,
                                               const FlattenResult& result, const FlattenResult& other);

/// What is wrong with an error itself: no sentence, no elements, elements that the input does not have.
std::vector<std::string> faults_of_error(const FlattenError& error, const FlattenInput& input);

}  // namespace wirewarp::test
