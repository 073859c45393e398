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

/// The solutions of a coupled group, which usually has one chart. Errors are valid only for an equal name_key.
struct CachedGroup {
  std::vector<SolvedChart> solved;
  std::string name_key;
};

struct CachedCharts {
  std::map<std::string, std::shared_ptr<const CachedGroup>> by_key;  // keyed by solution_key()
};

/// Looks up the charts of one run of flatten() in a cache, and collects their solutions for the next run. Any thread
/// may call known() and keep().
class CacheSession {
 public:
  /// cache: null if the run has no cache.
  CacheSession(Cache* cache, const FlattenInput& input, const Options& options);

  /// Returns the solutions of a coupled group if the cache has them, and keeps them for the next run. Returns errors
  /// only if they name the same elements and wires as in this run.
  std::optional<std::vector<SolvedChart>> known(const std::vector<const Chart*>& group);

  /// Keeps the solutions of a group for the next run, unless a solution was canceled.
  void keep(const std::vector<const Chart*>& group, const std::vector<const SolvedChart*>& solved);

  /// Replaces the contents of the cache with the charts of this run.
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
