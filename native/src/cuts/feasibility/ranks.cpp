// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/ranks.h"

#include <algorithm>
#include <numeric>

namespace wirewarp {

std::vector<int> ranks_of(const std::vector<double>& values, double same) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<int> ranks(values.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const bool is_higher = values[order[i]] - values[order[i - 1]] > same;
    ranks[order[i]] = ranks[order[i - 1]] + (is_higher ? 1 : 0);
  }
  return ranks;
}

std::vector<std::size_t> highest_first(const std::vector<double>& values, double same) {
  const std::vector<int> ranks = ranks_of(values, same);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ranks[a] > ranks[b]; });
  return order;
}

}  // namespace wirewarp
