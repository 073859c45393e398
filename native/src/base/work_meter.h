// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "base/stop_token.h"

namespace wirewarp {

/// Asks whether to go on after a fixed amount of work, however little is done at a time: as often in one large piece as
/// in thousands of small ones.
class WorkMeter {
 public:
  /// Faces, edges or pairs looked at between two questions: some milliseconds.
  static constexpr std::size_t work_per_question = 20'000;

  explicit WorkMeter(StopToken stop) : stop_(std::move(stop)) {}

  /// Throws Stopped.
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
