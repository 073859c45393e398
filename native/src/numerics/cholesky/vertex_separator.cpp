// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/vertex_separator.h"

#include <utility>

namespace wirewarp {

VertexSeparator::VertexSeparator(const Graph& graph)
    : graph_(graph), partner_(graph.num_vertices(), -1), via_(partner_.size()), seen_(partner_.size(), 0) {}

/// Later searches cannot reach the vertices of a failed search. The upper vertices of failed searches, and the lower
/// vertices that no failed search visited, cover all edges across the cut. Both kinds of vertices form the separator.
void VertexSeparator::separate(const std::vector<int>& cut, std::vector<Side>& side) {
  for (int v : cut) {
    if (side[v] != Side::lower_cut || match(v, side)) continue;
    for (int met : lower_met_) side[met] = Side::lower;
    for (int met : upper_met_) side[met] = Side::separator;
  }
  for (int v : cut) {
    partner_[v] = -1;
    if (side[v] == Side::lower_cut) side[v] = Side::separator;
    if (side[v] == Side::upper_cut) side[v] = Side::upper;
  }
}

/// Searches breadth first for an augmenting path. Such a path leads from a lower vertex to an upper vertex without a
/// partner, alternately along edges outside and inside the matching. Augments the matching along this path.
bool VertexSeparator::match(int vertex, const std::vector<Side>& side) {
  ++search_;
  lower_met_ = {vertex};
  upper_met_.clear();
  for (std::size_t next = 0; next < lower_met_.size(); ++next) {
    const int lower = lower_met_[next];
    for (int i = graph_.start[lower]; i < graph_.start[lower + 1]; ++i) {
      int upper = graph_.neighbors[i];
      if (side[upper] != Side::upper_cut || seen_[upper] == search_) continue;
      seen_[upper] = search_;
      via_[upper] = lower;
      upper_met_.push_back(upper);
      if (partner_[upper] != -1) {
        lower_met_.push_back(partner_[upper]);
        continue;
      }
      while (upper != -1) {
        const int from = via_[upper];
        partner_[upper] = from;
        upper = std::exchange(partner_[from], upper);
      }
      return true;
    }
  }
  return false;
}

}  // namespace wirewarp
