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

/// Solutions of charts that were solved together, mostly of one, and what their errors speak of.
struct CachedGroup {
  std::vector<SolvedChart> solved;
  std::string name_key;
};

struct CachedCharts {
  std::map<std::string, std::shared_ptr<const CachedGroup>> by_key;  // solution_key()
};

/// The charts of one run of flatten(), looked up in its cache and collected for it. In any thread.
class CacheSession {
 public:
  /// cache: null: nothing is known, and nothing kept.
  CacheSession(Cache* cache, const FlattenInput& input, const Options& options);

  /// Sound charts that are solved together, solved in the last run; then they are kept. None: they are not known.
  std::optional<std::vector<SolvedChart>> known(const std::vector<const Chart*>& group);

  /// Keeps them, where none of them was cancelled.
  void keep(const std::vector<const Chart*>& group, const std::vector<const SolvedChart*>& solved);

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
