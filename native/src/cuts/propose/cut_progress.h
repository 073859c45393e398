// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <thread>

#include "base/progress_report.h"
#include "base/stop_token.h"

namespace wirewarp {

/// Reports the progress of a search as stage "cuts", only in the thread that created this object. Each poll advances
/// the progress by a share of the rest of its range, because the duration is unknown.
class CutProgress {
 public:
  /// rounds: largest number of consecutive searches.
  explicit CutProgress(const Progress& progress, int rounds = 1) : report_(progress), rounds_(rounds) {}

  /// Returns a token that may be used in any thread.
  StopToken token() {
    return StopToken([this](const char*) {
      if (std::this_thread::get_id() != caller_) return !report_.is_cancelled();
      const double polled = num_polled_++;
      const double in_round = from_ + (to_ - from_) * polled / (polled + kTypicalPolls);
      reached_ = std::max(reached_, (num_done_ + in_round) / rounds_);
      return report_.go_on("cuts", reached_);
    });
  }

  /// Sets the number of finished rounds.
  void finish_rounds(int count) {
    num_done_ = count;
    begin_part(0, 1);
  }

  /// Begins a part of the current round. from, to: range of the part, as shares of the round.
  void begin_part(double from, double to) {
    part_from_ = from;
    part_to_ = to;
    enter(0, 1);
  }

  /// Limits the following progress to a range of the current part. from, to: shares of the part. Reported progress
  /// never decreases.
  void enter(double from, double to) {
    from_ = part_from_ + (part_to_ - part_from_) * from;
    to_ = part_from_ + (part_to_ - part_from_) * to;
    num_polled_ = 0;
  }

  /// Sets the progress to a share of the current part. Polls do not advance it.
  void stay_at(double share) { enter(share, share); }

 private:
  /// Approximate number of polls in a search for darts in a piece of a few thousand triangles.
  static constexpr int kTypicalPolls = 2000;

  ProgressReport report_;
  const std::thread::id caller_ = std::this_thread::get_id();
  const int rounds_;
  int num_done_ = 0;
  int num_polled_ = 0;
  double part_from_ = 0, part_to_ = 1;  // shares of the round
  double from_ = 0, to_ = 1;            // range of enter(), as shares of the round
  double reached_ = 0;
};

}  // namespace wirewarp
