// SPDX-License-Identifier: GPL-3.0-or-later
#include "cache/cache_session.h"

#include "cache/chart_key.h"

namespace wirewarp {

Cache::Cache() : solved_(std::make_shared<CachedCharts>()) {}

int Cache::size() const { return static_cast<int>(solved()->by_key.size()); }

void Cache::clear() { hold(std::make_shared<CachedCharts>()); }

std::shared_ptr<const CachedCharts> Cache::solved() const {
  const std::lock_guard lock(mutex_);
  return solved_;
}

void Cache::hold(std::shared_ptr<const CachedCharts> solved) {
  const std::lock_guard lock(mutex_);
  solved_.swap(solved);  // what it held is freed after the lock
}

CacheSession::CacheSession(Cache* cache, const FlattenInput& input, const Options& options)
    : cache_(cache), input_(input), options_(options), known_(cache ? cache->solved() : nullptr) {}

SolvedChart CacheSession::solved(const Chart& chart, const std::function<SolvedChart()>& solve) {
  if (!cache_) return solve();
  std::string key = solution_key(chart, options_);
  std::string names = name_key(chart, input_.wires);
  const auto known = known_->by_key.find(key);
  if (known != known_->by_key.end() && (!known->second->solved.error || known->second->name_key == names)) {
    const std::lock_guard lock(mutex_);
    ++num_reused_;
    of_this_run_.by_key.insert(*known);
    return known->second->solved;
  }
  auto cached = std::make_shared<CachedChart>(CachedChart{solve(), std::move(names)});
  SolvedChart solved = cached->solved;
  if (solved.report.termination == Termination::cancelled) return solved;
  cached->solved.report.seconds.clear();  // no time is spent on it again
  const std::lock_guard lock(mutex_);
  of_this_run_.by_key.insert_or_assign(std::move(key), std::move(cached));
  return solved;
}

void CacheSession::finish() {
  if (cache_) cache_->hold(std::make_shared<CachedCharts>(std::move(of_this_run_)));
}

}  // namespace wirewarp
