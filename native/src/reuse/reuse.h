// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "metrics/assemble_result.h"
#include "wirewarp/cache.h"

namespace wirewarp {

/// A solution and what its error speaks of.
struct SolvedChart {
  Layout layout;
  std::string name_key;
};

struct SolvedCharts {
  std::map<std::string, std::shared_ptr<const SolvedChart>> by_key;  // solution_key()
};

/// The charts of one run of flatten(), looked up in its cache and collected for it.
class Reuse {
 public:
  /// cache: null: every chart is solved.
  Reuse(Cache* cache, const FlattenInput& input, const Options& options);

  /// The layout of a sound chart: the known one, or the one that solve() makes. Whole ones are kept. In any thread.
  Layout layout_of(const Chart& chart, const std::function<Layout()>& solve);

  /// Hands all layouts of this run to the cache, in place of those it held.
  void finish();

  int num_reused() const { return num_reused_; }

 private:
  Cache* cache_;
  const FlattenInput& input_;
  const Options& options_;
  std::shared_ptr<const SolvedCharts> known_;
  std::mutex mutex_;  // of the two below
  SolvedCharts of_this_run_;
  int num_reused_ = 0;
};

}  // namespace wirewarp
