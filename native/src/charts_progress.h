// SPDX-License-Identifier: GPL-3.0-or-later
// How far the charts of a run are, solved side by side.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "charts/chart.h"
#include "progress_report.h"

namespace wirewarp {

/// Gathers the steps of all charts; tells them in the thread that made it alone, as callers expect.
class ChartsProgress {
 public:
  ChartsProgress(ProgressReport& report, const std::vector<Chart>& charts);

  /// At a step of a chart, in any thread. False once the caller has cancelled.
  bool go_on(std::size_t chart, const char* stage);

  /// In any thread.
  void finish(std::size_t chart);

  /// How far all charts are, in the thread that made this. False once the caller has cancelled.
  bool tell();

 private:
  void advance(std::size_t chart, double share);

  ProgressReport& report_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::mutex mutex_;
  std::vector<double> part_of_all_;  // per chart
  std::vector<double> share_done_;   // per chart, of its own part
  double done_ = 0;
  std::string stage_ = "charts";  // begun last
};

}  // namespace wirewarp
