// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace wirewarp {

/// Disjoint sets with path halving. The smallest index of a set is its root.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  /// Unites the sets of i and j. Returns false if they were already one set.
  bool unite(int i, int j) {
    i = find(i);
    j = find(j);
    parent(std::max(i, j)) = std::min(i, j);
    return i != j;
  }
  /// Returns, for each member, the index of its set. Sets are numbered in the order of their smallest member. Stores
  /// the number of sets in count.
  std::vector<int> number(int& count) {
    std::vector<int> label(parent_.size());
    count = 0;
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
      const int root = find(i);
      label[i] = root == i ? count++ : label[root];
    }
    return label;
  }

 private:
  int& parent(int i) { return parent_[i]; }
  std::vector<int> parent_;
};

}  // namespace wirewarp
