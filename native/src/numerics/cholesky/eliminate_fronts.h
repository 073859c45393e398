// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "base/stop_token.h"
#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/front_layout.h"

namespace wirewarp {

/// Fills the panel and the Schur complement of a front from the values of a lower triangle and the front's children.
/// factor, schurs: panels and Schur complements of all fronts.
void assemble_front(const FrontLayout& layout, int node, const double* values, Tile* factor, Tile* schurs);

/// Number of tile multiplications between two calls of the stop token, about 0.1 s. Calls are rare, because each call
/// advances the progress bar: there are forty calls for a million triangles, and no calls below 50,000 triangles.
constexpr double kWorkPerQuestion = 1e7;

/// Calls eliminate(front) for all fronts, children before parents, in two threads if requested. Returns false
/// immediately if a front cannot be eliminated or the caller stops. Only the calling thread polls the stop token.
template <typename Eliminate>
bool eliminate_fronts(const FrontLayout& layout, bool in_threads, const StopToken& stop, const Eliminate& eliminate) {
  std::atomic<bool> is_good{true};
  const std::thread::id caller = std::this_thread::get_id();
  double work = 0;  // tile multiplications of the calling thread since the last call of the token
  const auto may_go_on = [&](const Front& next) {
    if (std::this_thread::get_id() != caller) return true;
    if (work > kWorkPerQuestion && !stop.may_go_on()) return false;
    work = (work > kWorkPerQuestion ? 0 : work) + next.work();
    return true;
  };
  const auto eliminate_all = [&](const std::vector<int>& fronts) {
    for (int f : fronts) {
      if (is_good && !(may_go_on(layout.fronts[f]) && eliminate(f))) is_good = false;
    }
  };
  layout.all_fronts.visit_subtrees(in_threads,
                                   [&](std::size_t, const std::vector<int>& fronts) { eliminate_all(fronts); });
  eliminate_all(layout.all_fronts.ancestors);
  return is_good;
}

}  // namespace wirewarp
