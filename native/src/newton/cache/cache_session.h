// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "newton/solved_chart.h"
#include "wirewarp/cache.h"

namespace wirewarp {

/// Solutions of charts that were solved together, usually of one chart, and the names that their errors use.
struct CachedGroup {
  std::vector<SolvedChart> solved;
  std::string name_key;
};

struct CachedCharts {
  std::map<std::string, std::shared_ptr<const CachedGroup>> by_key;  // solution_key()
};

/// The charts of one run of flatten(), which are looked up in its cache and collected for it. May be used in any
/// thread.
class CacheSession {
 public:
  /// cache: null to look nothing up and keep nothing.
  CacheSession(Cache* cache, const FlattenInput& input, const Options& options);

  /// Returns the solutions of sound charts that are solved together, if the last run had them, and keeps them for the
  /// next one.
  std::optional<std::vector<SolvedChart>> known(const std::vector<const Chart*>& group);

  /// Keeps solutions for the next run, unless one of them was canceled.
  void keep(const std::vector<const Chart*>& group, const std::vector<const SolvedChart*>& solved);

  /// Replaces the contents of the cache by all charts of this run.
  void finish();

  int num_reused() const { return num_reused_; }

 private:
  Cache* cache_;
  const FlattenInput& input_;
  const Options& options_;
  std::shared_ptr<const CachedCharts> known_;
  std::mutex mutex_;  // guards the two members below
  CachedCharts of_this_run_;
  int num_reused_ = 0;
};

}  // namespace wirewarp
