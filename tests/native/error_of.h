// SPDX-License-Identifier: GPL-3.0-or-later
// Returns the error that a call throws, and searches its message for words.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "wirewarp/error.h"

namespace wirewarp::test {

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

inline void expect_words(const std::string& message, const std::string& words) {
  EXPECT_NE(message.find(words), std::string::npos) << '"' << words << "\" is not in: " << message;
}

inline void expect_words(const FlattenError& error, const std::string& words) { expect_words(error.what(), words); }

}  // namespace wirewarp::test
