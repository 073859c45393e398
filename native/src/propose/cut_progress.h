// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <thread>

#include "progress_report.h"
#include "stop_token.h"

namespace wirewarp {

/// Reports the stage "cuts" of a search, in the thread that made it alone. How long a search takes is not known
/// beforehand: each poll is a share of what is left.
class CutProgress {
 public:
  /// rounds: searches after one another, at most.
  explicit CutProgress(const Progress& progress, int rounds = 1) : report_(progress), rounds_(rounds) {}

  /// For any thread.
  StopToken token() {
    return StopToken([this](const char*) {
      if (std::this_thread::get_id() != caller_) return !report_.is_cancelled();
      const double polled = num_polled_++;
      return report_.go_on("cuts", (num_done_ + polled / (polled + kTypicalPolls)) / rounds_);
    });
  }

  /// So many rounds are over.
  void finish_rounds(int count) {
    num_done_ = count;
    num_polled_ = 0;
  }

 private:
  /// The search for darts in a piece of some thousand triangles polls about as often.
  static constexpr int kTypicalPolls = 2000;

  ProgressReport report_;
  const std::thread::id caller_ = std::this_thread::get_id();
  const int rounds_;
  int num_done_ = 0;
  int num_polled_ = 0;
};

}  // namespace wirewarp
