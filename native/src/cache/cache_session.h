// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "solved_chart.h"
#include "wirewarp/cache.h"

namespace wirewarp {

/// A solution and what its error speaks of.
struct CachedChart {
  SolvedChart solved;
  std::string name_key;
};

struct CachedCharts {
  std::map<std::string, std::shared_ptr<const CachedChart>> by_key;  // solution_key()
};

/// The charts of one run of flatten(), looked up in its cache and collected for it.
class CacheSession {
 public:
  /// cache: null: every chart is solved.
  CacheSession(Cache* cache, const FlattenInput& input, const Options& options);

  /// A sound chart, solved: as it is known, or by solve(). What was not cancelled is kept. In any thread.
  SolvedChart solved(const Chart& chart, const std::function<SolvedChart()>& solve);

  /// Hands all charts of this run to the cache, in place of those it held.
  void finish();

  int num_reused() const { return num_reused_; }

 private:
  Cache* cache_;
  const FlattenInput& input_;
  const Options& options_;
  std::shared_ptr<const CachedCharts> known_;
  std::mutex mutex_;  // of the two below
  CachedCharts of_this_run_;
  int num_reused_ = 0;
};

}  // namespace wirewarp
