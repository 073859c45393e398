// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the results of flatten() by the guarantees, without the library's own measurements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns a sentence for every broken guarantee of a result. unstretched: the result without the stretch if the fabric
/// is stretched when worn, otherwise null.
std::vector<std::string> broken_guarantees(const FlattenInput& input, const Options& options,
                                           const FlattenResult& result, const FlattenResult* unstretched = nullptr);

/// Returns a sentence for every broken expectation:
/// - Pieces that unfold have no distortion.
/// - Pieces that shrink evenly have the unstretched shape, shrunk along weft and warp.
/// - Legal input does not fail inside the solver.
///
/// fault: error code of the fault that was added to the input, if any.
std::vector<std::string> broken_expectations(const FlattenInput& input, const Options& options,
                                             const FlattenResult& result, const std::optional<ErrorCode>& fault,
                                             const FlattenResult* unstretched = nullptr);

/// Returns the differences in errors and shapes between two results, whose options differ only in the placement of
/// pieces.
std::vector<std::string> differences_of_layout(const FlattenInput& input, const Options& options,
                                               const FlattenResult& result, const FlattenResult& other);

/// Returns the faults of an error: a missing sentence, undocumented arguments, missing elements, or elements that the
/// input does not have.
std::vector<std::string> faults_of_error(const FlattenError& error, const FlattenInput& input);

}  // namespace wirewarp::test
