// SPDX-License-Identifier: GPL-3.0-or-later
// Progress, cancellation and the time of each stage of a run.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <string>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Passes progress to the caller, and remembers whether the caller canceled or threw an exception.
class ProgressReport {
 public:
  explicit ProgressReport(const Progress& progress) : progress_(progress) {}

  /// Returns false once the caller has canceled.
  bool go_on(const std::string& stage, double fraction) {
    if (is_cancelled_ || !progress_) return !is_cancelled_;
    try {
      if (!progress_(stage, fraction)) is_cancelled_ = true;  // never reset: another thread may have canceled
    } catch (...) {
      is_cancelled_ = true;  // stops the charts in other threads
      throw;
    }
    return !is_cancelled_;
  }

  /// Acts as if the caller had canceled. Any thread may call this function.
  void cancel() { is_cancelled_ = true; }

  bool is_cancelled() const { return is_cancelled_; }

 private:
  const Progress& progress_;
  std::atomic<bool> is_cancelled_{false};
};

/// Adds the seconds between its construction and destruction to seconds[stage].
class StageTimer {
 public:
  StageTimer(std::map<std::string, double>& seconds, std::string stage)
      : seconds_(seconds), stage_(std::move(stage)), start_(Clock::now()) {}
  ~StageTimer() { seconds_[stage_] += std::chrono::duration<double>(Clock::now() - start_).count(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  std::map<std::string, double>& seconds_;
  std::string stage_;
  Clock::time_point start_;
};

}  // namespace wirewarp
