// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/nested_dissection.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>

#include "numerics/cholesky/vertex_separator.h"

namespace wirewarp {
namespace {

// Maximum number of vertices of a leaf, which becomes one front. With 8 to 24 vertices, whole runs take the same time.
constexpr std::ptrdiff_t kLeafSize = 16;

// Directions in which a set of vertices is halved: x, y and the two diagonals, because meshes have no preferred
// direction. Even on an axis-parallel sheet, runs with x and y alone are not faster.
constexpr std::array<std::array<double, 2>, 4> kDirections = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

class Dissection {
 public:
  Dissection(const Graph& graph, const Positions2& positions)
      : graph_(graph),
        positions_(positions),
        cover_(graph),
        side_(graph.num_vertices(), Side::outside),
        keys_(side_.size()) {}

  DissectionTree run() {
    std::vector<char> is_met(side_.size(), 0);
    std::vector<int> last(side_.size() - static_cast<std::size_t>(positions_.rows()));
    std::iota(last.begin(), last.end(), static_cast<int>(positions_.rows()));
    for (const int v : last) is_met[v] = 1;
    std::vector<int> roots;
    for (std::size_t v = 0; v < side_.size(); ++v) {
      if (is_met[v]) continue;
      std::vector<int> part = all_joined_to(static_cast<int>(v), is_met);
      for (const int root : dissect(part.begin(), part.end())) roots.push_back(root);
    }
    if (!last.empty()) append(last.begin(), last.end(), roots);
    return std::move(tree_);
  }

 private:
  using Iterator = std::vector<int>::iterator;
  struct Cut {
    int lower = 0, upper = 0;  // for each half, the number of vertices with neighbors in the other half
    int smaller() const { return std::min(lower, upper); }
  };

  std::vector<int> all_joined_to(int vertex, std::vector<char>& is_met) const {
    std::vector<int> part{vertex};
    is_met[vertex] = 1;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const int v = part[next];
      for (int i = graph_.start[v]; i < graph_.start[v + 1]; ++i) {
        const int neighbor = graph_.neighbors[i];
        if (!std::exchange(is_met[neighbor], 1)) part.push_back(neighbor);
      }
    }
    std::sort(part.begin(), part.end());
    return part;
  }

  /// Appends the nodes for a set of vertices. All neighbors outside of the set must be in separators. Returns the roots
  /// of the new nodes.
  std::vector<int> dissect(Iterator begin, Iterator end) {
    if (begin == end) return {};
    if (end - begin <= kLeafSize) return {append(begin, end, {})};
    split(begin, end);
    const auto is_on = [this](Side side) { return [this, side](int v) { return side_[v] == side; }; };
    const auto lower_end = std::partition(begin, end, is_on(Side::lower));
    const auto upper_end = std::partition(lower_end, end, is_on(Side::upper));
    for (auto v = begin; v != end; ++v) side_[*v] = Side::outside;

    std::vector<int> roots = dissect(begin, lower_end);
    for (int root : dissect(lower_end, upper_end)) roots.push_back(root);
    if (upper_end == end) return roots;  // the halves are not connected
    return {append(upper_end, end, roots)};
  }

  int append(Iterator begin, Iterator end, const std::vector<int>& children) {
    const int node = static_cast<int>(tree_.nodes.size());
    std::sort(begin, end);
    tree_.nodes.push_back({{begin, end}, -1});
    for (int child : children) tree_.nodes[child].parent = node;
    return node;
  }

  /// Finds the direction with the smallest cut; marks its halves and the separator in side_.
  void split(Iterator begin, Iterator end) {
    Cut best;
    std::size_t best_direction = kDirections.size();
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      const Cut cut = halve(begin, end, kDirections[d]);
      if (best_direction < kDirections.size() && cut.smaller() >= best.smaller()) continue;
      best = cut;
      best_direction = d;
    }
    if (best_direction + 1 != kDirections.size()) halve(begin, end, kDirections[best_direction]);
    std::vector<int> cut;
    std::copy_if(begin, end, std::back_inserter(cut),
                 [this](int v) { return side_[v] == Side::lower_cut || side_[v] == Side::upper_cut; });
    cover_.separate(cut, side_);
  }

  /// Divides the vertices in two halves across a direction. Marks the halves, and the vertices at the cut. Returns the
  /// size of the cut.
  Cut halve(Iterator begin, Iterator end, const std::array<double, 2>& direction) {
    const auto middle = keys_.begin() + (end - begin) / 2;
    const auto last = std::transform(begin, end, keys_.begin(), [&](int v) {
      return std::pair{direction[0] * positions_(v, 0) + direction[1] * positions_(v, 1), v};
    });
    std::nth_element(keys_.begin(), middle, last);
    for (auto key = keys_.begin(); key != middle; ++key) side_[key->second] = Side::lower;
    for (auto key = middle; key != last; ++key) side_[key->second] = Side::upper;

    Cut cut;
    for (auto key = keys_.begin(); key != middle; ++key) {
      const int v = key->second;
      for (int i = graph_.start[v]; i < graph_.start[v + 1]; ++i) {
        Side& neighbor = side_[graph_.neighbors[i]];
        if (neighbor == Side::upper) {
          neighbor = Side::upper_cut;
          ++cut.upper;
        }
        if (neighbor == Side::upper_cut) side_[v] = Side::lower_cut;
      }
      if (side_[v] == Side::lower_cut) ++cut.lower;
    }
    return cut;
  }

  const Graph& graph_;
  const Positions2& positions_;
  VertexSeparator cover_;
  std::vector<Side> side_;  // side of each vertex in the set that is being split
  std::vector<std::pair<double, int>> keys_;
  DissectionTree tree_;
};

}  // namespace

DissectionTree nested_dissection(const Graph& graph, const Positions2& positions) {
  return Dissection(graph, positions).run();
}

}  // namespace wirewarp
