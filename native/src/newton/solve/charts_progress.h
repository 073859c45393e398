// SPDX-License-Identifier: GPL-3.0-or-later
// How far the charts of a run are, solved side by side.
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

/// Gathers the steps of all charts. Reports them in the thread that made it alone, as callers expect.
class ChartsProgress {
 public:
  /// begin, end: of all that is done for them, as fractions of the run.
  ChartsProgress(ProgressReport& report, const std::vector<Chart>& charts, double begin, double end);

  /// Calls work(0) to work(count - 1) on all cores. Once one has thrown, the others stop.
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
    if (count > 0) run_in_threads(count, num_cores(), work_or_stop_all, [&] { tell(); });
  }

  /// Whether the other charts keep all other cores busy: threads for this one alone would only take turns with them.
  bool is_one_of_many(std::size_t chart) const { return part_of_all_[chart] * static_cast<double>(num_cores()) <= 1; }

  /// For the work on a chart.
  StopToken stop_token(std::size_t chart) {
    return StopToken([this, chart](const char* stage) { return go_on(chart, stage); });
  }

  /// At a step of a chart, in any thread. False once the caller has cancelled.
  bool go_on(std::size_t chart, const char* stage);

  /// In any thread.
  void finish(std::size_t chart);

  /// How far all charts are, in the thread that made this. False once the caller has cancelled.
  bool tell();

 private:
  void advance(std::size_t chart, double share);

  ProgressReport& report_;
  double begin_, end_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::mutex mutex_;
  std::vector<double> part_of_all_;  // per chart
  std::vector<double> share_done_;   // per chart, of its own part
  double done_ = 0;
  std::string stage_ = "charts";  // begun last
};

}  // namespace wirewarp
