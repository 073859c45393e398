// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/edge_table.h"

#include <algorithm>

namespace wirewarp {

EdgeTable::EdgeTable(const Triangles& faces, int num_vertices) : faces_(faces) {
  const int num_sides = static_cast<int>(faces.rows()) * 3;

  // The sides are sorted into buckets by their smaller end, and each bucket by the larger end, then by side.
  std::vector<int> bucket(num_vertices + 1, 0);
  for (int s = 0; s < num_sides; ++s) ++bucket[std::min(from(s), to(s)) + 1];
  for (int v = 0; v < num_vertices; ++v) bucket[v + 1] += bucket[v];
  sides_.resize(num_sides);
  std::vector<int> next = bucket;
  for (int s = 0; s < num_sides; ++s) sides_[next[std::min(from(s), to(s))]++] = s;

  edge_begin_.resize(num_vertices + 1);
  edge_of_side_.resize(num_sides);
  for (int v = 0; v < num_vertices; ++v) {
    edge_begin_[v] = num_edges();
    const auto begin = sides_.begin() + bucket[v];
    const auto end = sides_.begin() + bucket[v + 1];
    const auto larger_end = [&](int s) { return std::max(from(s), to(s)); };
    std::sort(begin, end, [&](int s, int t) { return std::pair(larger_end(s), s) < std::pair(larger_end(t), t); });
    for (auto it = begin; it != end; ++it) {
      if (it == begin || larger_end(*it) != larger_end(*(it - 1))) {
        side_begin_.push_back(static_cast<int>(it - sides_.begin()));
        vertices_.push_back({v, larger_end(*it)});
      }
      edge_of_side_[*it] = num_edges() - 1;
    }
  }
  edge_begin_[num_vertices] = num_edges();
  side_begin_.push_back(num_sides);
}

int EdgeTable::find(int a, int b) const {
  const int smaller = std::min(a, b);
  const int larger = std::max(a, b);
  const auto begin = vertices_.begin() + edge_begin_[smaller], end = vertices_.begin() + edge_begin_[smaller + 1];
  const auto found =
      std::lower_bound(begin, end, larger, [](const VertexPair& edge, int vertex) { return edge[1] < vertex; });
  return found != end && (*found)[1] == larger ? static_cast<int>(found - vertices_.begin()) : -1;
}

}  // namespace wirewarp
