// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <vector>

#include "cholesky/front_kernels.h"
#include "cholesky/front_layout.h"

namespace wirewarp {

/// Fills the panel and the Schur complement of a front, before it is factored, from a lower triangle's values and the
/// Schur complements of its children. factor, schurs: those of all fronts.
void assemble_front(const FrontLayout& layout, int node, const double* values, Tile* factor, Tile* schurs);

/// Calls eliminate(front) for all fronts, children before their parents, in two threads if asked for. False, and at
/// once, where a front could not be eliminated.
template <typename Eliminate>
bool eliminate_fronts(const FrontLayout& layout, bool in_threads, const Eliminate& eliminate) {
  std::atomic<bool> is_good{true};
  const auto eliminate_all = [&](const std::vector<int>& fronts) {
    for (int f : fronts) {
      if (is_good && !eliminate(f)) is_good = false;
    }
  };
  layout.all_fronts.visit_subtrees(in_threads,
                                   [&](std::size_t, const std::vector<int>& fronts) { eliminate_all(fronts); });
  eliminate_all(layout.all_fronts.ancestors);
  return is_good;
}

}  // namespace wirewarp
