// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "base/stop_token.h"

namespace wirewarp {

/// Polls a stop token after a fixed amount of work, so that polls are as regular in one large piece as in thousands of
/// small pieces.
class WorkMeter {
 public:
  /// Number of faces, edges or pairs visited between two polls, which takes a few milliseconds.
  static constexpr std::size_t work_per_question = 20'000;

  explicit WorkMeter(StopToken stop) : stop_(std::move(stop)) {}

  /// Adds to the work done. Throws Stopped if the token is polled and the work should stop.
  void did(std::size_t work) {
    done_ += work;
    if (done_ < work_per_question) return;
    done_ = 0;
    stop_.check();
  }

 private:
  StopToken stop_;
  std::size_t done_ = 0;
};

}  // namespace wirewarp
