// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "base/stop_token.h"
#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/front_layout.h"

namespace wirewarp {

/// Fills the panel and the Schur complement of a front, before it is factored, from a lower triangle's values and the
/// Schur complements of its children. factor, schurs: those of all fronts.
void assemble_front(const FrontLayout& layout, int node, const double* values, Tile* factor, Tile* schurs);

/// Multiplications of tiles between two questions whether to go on: a tenth of a second. Few enough for a progress bar
/// that each of them moves on: none below 50,000 triangles, forty a factorization of a million.
constexpr double kWorkPerQuestion = 1e7;

/// Calls eliminate(front) for all fronts, children before their parents, in two threads if asked for. False, and at
/// once, where a front could not be eliminated, or where the caller stops; who is asked in this thread alone.
template <typename Eliminate>
bool eliminate_fronts(const FrontLayout& layout, bool in_threads, const StopToken& stop, const Eliminate& eliminate) {
  std::atomic<bool> is_good{true};
  const std::thread::id caller = std::this_thread::get_id();
  double work = 0;  // of this thread, since the last question
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
