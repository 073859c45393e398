// SPDX-License-Identifier: GPL-3.0-or-later
// Good results, and changes that break one guarantee each. The judge of tests/judge must report every change.
#pragma once

#include <functional>
#include <string>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// The arguments of the judge.
struct JudgeCase {
  FlattenInput input;
  Options options;
  FlattenResult result;
};

JudgeCase flattened(const FlattenInput& input, const Options& options = {});

/// A saddle of 8 by 8 quads with vertices i + 9 j, cut along i = 4 into two pieces in a row. Wire "rigid" runs
/// along j = 4 through both, "elastic" along i = 2 in piece 0, where it is upright, and "other" along i = 6 in piece 1.
JudgeCase two_sheets();

using Spoil = std::function<void(JudgeCase&)>;

/// Expects that broken_guarantees() reports nothing for the good case and, for the spoiled case, a sentence that
/// contains `sentence`.
void expect_broken(const std::string& sentence, JudgeCase good, const Spoil& spoil);

/// Expects the same of broken_expectations() without an expected error.
void expect_broken_expectation(const std::string& sentence, JudgeCase good, const Spoil& spoil);

// Move or turn the piece with this number, together with its corners in corner_uv. Directions are in the plane of the
// piece.
Spoil moved_vertex(int number, int source_vertex, double right, double up);
Spoil moved(int number, double right, double up);
Spoil turned(int number, double angle);

/// Sets an error with a layout and one named vertex for a piece of two_sheets().
void fail(JudgeCase& sheets, ErrorCode code, int number = 0);

}  // namespace wirewarp::test
