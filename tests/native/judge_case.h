// SPDX-License-Identifier: GPL-3.0-or-later
// Makes good results, and changes that break one guarantee each. The judge of tests/judge must report every change.
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

/// Returns a saddle of 8 by 8 quads with vertices i + 9 j. It is cut along i = 4 into two pieces, which are laid out in
/// a row. Wire "rigid" runs along j = 4 through both pieces. Wire "elastic" runs along i = 2 in piece 0 and is upright
/// there. Wire "other" runs along i = 6 in piece 1.
JudgeCase two_sheets();

using Spoil = std::function<void(JudgeCase&)>;

/// Expects that broken_guarantees() reports nothing for the good case and, for the spoiled case, a sentence that
/// contains `sentence`.
void expect_broken(const std::string& sentence, JudgeCase good, const Spoil& spoil);

/// Does what expect_broken() does, but with broken_expectations() and no expected error.
void expect_broken_expectation(const std::string& sentence, JudgeCase good, const Spoil& spoil);

// Return changes that move one vertex of a piece, move a whole piece, or rotate a whole piece. The changes include
// corner_uv. right, up: distances in scene units along the axes of the layout. angle: radians.
Spoil moved_vertex(int number, int source_vertex, double right, double up);
Spoil moved(int number, double right, double up);
Spoil turned(int number, double angle);

/// Sets the error of a piece of two_sheets(). The error names one vertex, and the piece keeps its layout.
void fail(JudgeCase& sheets, ErrorCode code, int number = 0);

}  // namespace wirewarp::test
