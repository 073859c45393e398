// SPDX-License-Identifier: GPL-3.0-or-later
#include "reuse/reuse.h"

#include "reuse/chart_key.h"

namespace wirewarp {

Cache::Cache() : solved_(std::make_shared<SolvedCharts>()) {}

int Cache::size() const { return static_cast<int>(solved()->by_key.size()); }

void Cache::clear() { hold(std::make_shared<SolvedCharts>()); }

std::shared_ptr<const SolvedCharts> Cache::solved() const {
  const std::lock_guard lock(mutex_);
  return solved_;
}

void Cache::hold(std::shared_ptr<const SolvedCharts> solved) {
  const std::lock_guard lock(mutex_);
  solved_.swap(solved);  // what it held is freed after the lock
}

Reuse::Reuse(Cache* cache, const FlattenInput& input, const Options& options)
    : cache_(cache), input_(input), options_(options), known_(cache ? cache->solved() : nullptr) {}

Layout Reuse::layout_of(const Chart& chart, const std::function<Layout()>& solve) {
  if (!cache_) return solve();
  std::string key = solution_key(chart, options_);
  std::string names = name_key(chart, input_.wires);
  const auto known = known_->by_key.find(key);
  if (known != known_->by_key.end() && (!known->second->layout.error || known->second->name_key == names)) {
    const std::lock_guard lock(mutex_);
    ++num_reused_;
    of_this_run_.by_key.insert(*known);
    return known->second->layout;
  }
  auto solved = std::make_shared<SolvedChart>(SolvedChart{solve(), std::move(names)});
  Layout layout = solved->layout;
  if (layout.report.termination == Termination::cancelled) return layout;
  solved->layout.report.seconds.clear();  // no time is spent on it again
  const std::lock_guard lock(mutex_);
  of_this_run_.by_key.insert_or_assign(std::move(key), std::move(solved));
  return layout;
}

void Reuse::finish() {
  if (cache_) cache_->hold(std::make_shared<SolvedCharts>(std::move(of_this_run_)));
}

}  // namespace wirewarp
