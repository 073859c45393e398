// SPDX-License-Identifier: GPL-3.0-or-later
// The progress of charts that are solved in parallel.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/in_threads.h"
#include "base/progress_report.h"
#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Collects the steps of all charts, and reports them in the thread that created this object, as callers of flatten()
/// expect.
class ChartsProgress {
 public:
  /// begin, end: range of the charts' work, as fractions of the run.
  ChartsProgress(ProgressReport& report, const std::vector<Chart>& charts, double begin, double end);

  /// Calls work(0) to work(count - 1) on all cores. If one call throws, the others stop.
  template <typename Work>
  void run(std::size_t count, const Work& work) {
    const auto work_or_stop_all = [&](std::size_t i) {
      try {
        work(i);
      } catch (...) {
        report_.cancel();
        throw;
      }
    };
    if (count > 0) run_in_threads(count, num_cores(), work_or_stop_all, [&] { report(); });
  }

  /// Returns whether the other charts are enough for all other cores, so that more threads for this chart would gain
  /// nothing.
  bool is_one_of_many(std::size_t chart) const { return part_of_all_[chart] * static_cast<double>(num_cores()) <= 1; }

  StopToken stop_token(std::size_t chart) {
    return StopToken([this, chart](const char* stage) { return go_on(chart, stage); });
  }

  /// Reports a step of a chart; may be called in any thread. Returns false once the caller has canceled.
  bool go_on(std::size_t chart, const char* stage);

  /// Reports that a chart is finished; may be called in any thread.
  void finish(std::size_t chart);

  /// Reports the progress of all charts, in the thread that created this object. Returns false once the caller has
  /// canceled.
  bool report();

 private:
  void advance(std::size_t chart, double share);

  ProgressReport& report_;
  double begin_, end_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::mutex mutex_;
  std::vector<double> part_of_all_;  // per chart: its share of the whole work
  std::vector<double> share_done_;   // per chart: finished share of its own work
  double done_ = 0;
  std::string stage_ = "charts";  // the latest stage
};

}  // namespace wirewarp
