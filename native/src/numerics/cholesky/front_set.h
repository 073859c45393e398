// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/in_threads.h"

namespace wirewarp {

/// Fronts to visit: two shares of independent subtrees with about equal work, and their common ancestors. Children come
/// before parents. A single thread uses the same shares, so that its results are equal to the last bit.
struct FrontSet {
  static constexpr std::size_t num_shares = 2;

  std::array<std::vector<int>, num_shares> subtrees;
  std::vector<int> ancestors;
  bool are_worth_threads = true;

  /// Calls visit(share, its fronts) for both shares of the subtrees, in two threads if allowed and worthwhile.
  template <typename Visit>
  void visit_subtrees(bool in_threads, const Visit& visit) const {
    run_in_threads(num_shares, in_threads && are_worth_threads ? num_shares : 1,
                   [&](std::size_t share) { visit(share, subtrees[share]); });
  }
};

}  // namespace wirewarp
