// SPDX-License-Identifier: GPL-3.0-or-later
// Expectations about errors, and about results without errors.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "judge.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Expects that no piece has an error, and that every guarantee is kept.
inline void expect_good(const FlattenInput& input, const FlattenResult& result, const Options& options = {}) {
  for (const Piece& piece : result.pieces) EXPECT_FALSE(piece.error) << piece.error->what();
  EXPECT_EQ(broken_guarantees(input, options, result), std::vector<std::string>{});
}

/// Returns the FlattenError that a call throws. The test fails if the call throws nothing.
template <typename Call>
FlattenError error_of(const Call& call) {
  try {
    call();
  } catch (const FlattenError& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return FlattenError(ErrorCode::cancelled, "nothing was thrown");
}

/// Returns the error. The test fails if there is no error, or if its code is not `code`.
inline FlattenError expect_error(const std::optional<FlattenError>& error, ErrorCode code) {
  if (!error) ADD_FAILURE() << "there is no error";
  const FlattenError found = error.value_or(FlattenError(ErrorCode::cancelled, "there is no error"));
  EXPECT_EQ(found.code, code) << found.what();
  return found;
}

inline void expect_words(const std::string& message, const std::string& words) {
  EXPECT_NE(message.find(words), std::string::npos) << '"' << words << "\" is not in: " << message;
}

inline void expect_words(const FlattenError& error, const std::string& words) { expect_words(error.what(), words); }

}  // namespace wirewarp::test
