// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/cache/cache_session.h"

#include <algorithm>
#include <utility>

#include "newton/cache/chart_key.h"

namespace wirewarp {

Cache::Cache() : solved_(std::make_shared<CachedCharts>()) {}

int Cache::size() const {
  const std::shared_ptr<const CachedCharts> held = solved();
  std::size_t size = 0;
  for (const auto& [key, group] : held->by_key) size += group->solved.size();
  return static_cast<int>(size);
}

void Cache::clear() { hold(std::make_shared<CachedCharts>()); }

std::shared_ptr<const CachedCharts> Cache::solved() const {
  const std::lock_guard lock(mutex_);
  return solved_;
}

void Cache::hold(std::shared_ptr<const CachedCharts> solved) {
  const std::lock_guard lock(mutex_);
  solved_.swap(solved);  // the old contents are freed after the lock is released
}

CacheSession::CacheSession(Cache* cache, const FlattenInput& input, const Options& options)
    : cache_(cache), input_(input), options_(options), known_(cache ? cache->solved() : nullptr) {}

std::optional<std::vector<SolvedChart>> CacheSession::known(const std::vector<const Chart*>& group) {
  if (!cache_) return std::nullopt;
  const auto known = known_->by_key.find(solution_key(group, options_));
  if (known == known_->by_key.end()) return std::nullopt;
  const std::vector<SolvedChart>& solved = known->second->solved;
  const bool has_error = std::any_of(solved.begin(), solved.end(), [](const SolvedChart& one) { return one.error; });
  if (has_error && known->second->name_key != name_key(group, input_.wires)) return std::nullopt;
  const std::lock_guard lock(mutex_);
  num_reused_ += static_cast<int>(solved.size());
  of_this_run_.by_key.insert(*known);
  return solved;
}

void CacheSession::keep(const std::vector<const Chart*>& group, const std::vector<const SolvedChart*>& solved) {
  const bool is_cancelled = std::any_of(solved.begin(), solved.end(), [](const SolvedChart* one) {
    return one->report.termination == Termination::cancelled;
  });
  if (!cache_ || is_cancelled) return;
  auto cached = std::make_shared<CachedGroup>();
  cached->name_key = name_key(group, input_.wires);
  for (const SolvedChart* one : solved) {
    cached->solved.push_back(*one);
    cached->solved.back().report.seconds.clear();  // because a reused solution takes no time
  }
  std::string key = solution_key(group, options_);
  const std::lock_guard lock(mutex_);
  of_this_run_.by_key.insert_or_assign(std::move(key), std::move(cached));
}

void CacheSession::finish() {
  if (cache_) cache_->hold(std::make_shared<CachedCharts>(std::move(of_this_run_)));
}

}  // namespace wirewarp
