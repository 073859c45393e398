// SPDX-License-Identifier: GPL-3.0-or-later
// Results to spoil, one promise at a time: the judge of tests/judge has to tell.
#pragma once

#include <functional>
#include <string>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// What the judge is given.
struct JudgeCase {
  FlattenInput input;
  Options options;
  FlattenResult result;
};

JudgeCase flattened(const FlattenInput& input, const Options& options = {});

/// A saddle of 8 by 8 quads, vertex i + 9 j, cut into two pieces along i = 4, in a row. The wires are "rigid" along
/// j = 4 through both, "elastic" along i = 2, upright in piece 0, and "other" along i = 6 in piece 1.
JudgeCase two_sheets();

using Spoil = std::function<void(JudgeCase&)>;

/// broken_guarantees() finds nothing in the good case, and says the sentence, or a longer one with it, once it is
/// spoiled.
void expect_broken(const std::string& sentence, JudgeCase good, const Spoil& spoil);

/// The same of broken_expectations(); the input was given no error.
void expect_demanded(const std::string& sentence, JudgeCase good, const Spoil& spoil);

// Spoil the piece of this number, in its own coordinates and the corners alike.
Spoil moved_vertex(int number, int source_vertex, double right, double up);
Spoil moved(int number, double right, double up);
Spoil turned(int number, double angle);

/// Gives piece 0 of the two sheets an error with a layout that names a vertex of it.
void fail(JudgeCase& sheets, ErrorCode code);

}  // namespace wirewarp::test
