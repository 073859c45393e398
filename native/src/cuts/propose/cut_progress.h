// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <thread>

#include "base/progress_report.h"
#include "base/stop_token.h"

namespace wirewarp {

/// Reports the stage "cuts" of a search, in the thread that made it alone. How long a search takes is not known
/// beforehand: each poll is a share of what is left, unless the search says how far it is.
class CutProgress {
 public:
  /// rounds: searches after one another, at most.
  explicit CutProgress(const Progress& progress, int rounds = 1) : report_(progress), rounds_(rounds) {}

  /// For any thread.
  StopToken token() {
    return StopToken([this](const char*) {
      if (std::this_thread::get_id() != caller_) return !report_.is_cancelled();
      const double polled = num_polled_++;
      const double in_round = from_ + (to_ - from_) * polled / (polled + kTypicalPolls);
      reached_ = std::max(reached_, (num_done_ + in_round) / rounds_);
      return report_.go_on("cuts", reached_);
    });
  }

  /// So many rounds are over.
  void finish_rounds(int count) {
    num_done_ = count;
    enter(0, 1);
  }

  /// The round is now between these shares of it. What has been reached stays.
  void enter(double from, double to) {
    from_ = from;
    to_ = to;
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
  double from_ = 0, to_ = 1;
  double reached_ = 0;
};

}  // namespace wirewarp
