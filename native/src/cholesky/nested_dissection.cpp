// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholesky/nested_dissection.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "index.h"

namespace wirewarp {
namespace {

constexpr std::ptrdiff_t kLeafSize = 16;

// Which way a set of vertices is halved: across x, y and the two diagonals.
constexpr std::array<std::array<double, 2>, 4> kDirections = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

class Dissection {
 public:
  Dissection(const Graph& graph, const Positions2& positions)
      : graph_(graph), positions_(positions), side_(at(graph.num_vertices()), kOutside), keys_(side_.size()) {}

  DissectionTree run() {
    std::vector<int> vertices(side_.size());
    std::iota(vertices.begin(), vertices.end(), 0);
    dissect(vertices.begin(), vertices.end());
    return std::move(tree_);
  }

 private:
  using Iterator = std::vector<int>::iterator;
  enum Side : char { kOutside, kLower, kUpper, kLowerCut, kUpperCut };
  struct Cut {
    int lower = 0, upper = 0;  // vertices of each half with neighbors in the other
    int smaller() const { return std::min(lower, upper); }
  };

  /// Appends the nodes of a set of vertices whose only neighbors outside are in separators. Returns their roots.
  std::vector<int> dissect(Iterator begin, Iterator end) {
    if (begin == end) return {};
    if (end - begin <= kLeafSize) return {append(begin, end, {})};
    const Side separator = split(begin, end);
    const auto is_lower = [&](int v) {
      return side_[at(v)] == kLower || (side_[at(v)] == kLowerCut && separator == kUpperCut);
    };
    const auto lower_end = std::partition(begin, end, is_lower);
    const auto upper_end = std::partition(lower_end, end, [&](int v) { return side_[at(v)] != separator; });
    for (auto v = begin; v != end; ++v) side_[at(*v)] = kOutside;

    std::vector<int> roots = dissect(begin, lower_end);
    for (int root : dissect(lower_end, upper_end)) roots.push_back(root);
    if (upper_end == end) return roots;  // the halves are not joined
    return {append(upper_end, end, roots)};
  }

  int append(Iterator begin, Iterator end, const std::vector<int>& children) {
    const int node = static_cast<int>(tree_.nodes.size());
    std::sort(begin, end);
    tree_.nodes.push_back({{begin, end}, -1});
    for (int child : children) tree_.nodes[at(child)].parent = node;
    return node;
  }

  /// Marks the halves and their cuts in the direction with the smallest separator; says which cut that is.
  Side split(Iterator begin, Iterator end) {
    Cut best;
    std::size_t best_direction = kDirections.size();
    Cut cut;
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      cut = split(begin, end, kDirections[d]);
      if (best_direction < kDirections.size() && cut.smaller() >= best.smaller()) continue;
      best = cut;
      best_direction = d;
    }
    if (best_direction + 1 != kDirections.size()) split(begin, end, kDirections[best_direction]);
    return best.lower <= best.upper ? kLowerCut : kUpperCut;
  }

  Cut split(Iterator begin, Iterator end, const std::array<double, 2>& direction) {
    const auto middle = keys_.begin() + (end - begin) / 2;
    const auto last = std::transform(begin, end, keys_.begin(), [&](int v) {
      return std::pair{direction[0] * positions_(v, 0) + direction[1] * positions_(v, 1), v};
    });
    std::nth_element(keys_.begin(), middle, last);
    for (auto key = keys_.begin(); key != middle; ++key) side_[at(key->second)] = kLower;
    for (auto key = middle; key != last; ++key) side_[at(key->second)] = kUpper;

    Cut cut;
    for (auto key = keys_.begin(); key != middle; ++key) {
      const int v = key->second;
      for (int i = graph_.start[at(v)]; i < graph_.start[at(v) + 1]; ++i) {
        Side& neighbor = side_[at(graph_.neighbors[at(i)])];
        if (neighbor == kUpper) {
          neighbor = kUpperCut;
          ++cut.upper;
        }
        if (neighbor == kUpperCut) side_[at(v)] = kLowerCut;
      }
      if (side_[at(v)] == kLowerCut) ++cut.lower;
    }
    return cut;
  }

  const Graph& graph_;
  const Positions2& positions_;
  std::vector<Side> side_;  // of each vertex of the set that is being split
  std::vector<std::pair<double, int>> keys_;
  DissectionTree tree_;
};

}  // namespace

DissectionTree nested_dissection(const Graph& graph, const Positions2& positions) {
  return Dissection(graph, positions).run();
}

}  // namespace wirewarp
