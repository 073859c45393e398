// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholesky/cut_cover.h"

#include <utility>

#include "index.h"

namespace wirewarp {

CutCover::CutCover(const Graph& graph)
    : graph_(graph), partner_(at(graph.num_vertices()), -1), via_(partner_.size()), seen_(partner_.size(), 0) {}

/// What a search that fails has met stays out of reach of all later ones. It is covered by its upper vertices, all the
/// rest by the lower ones.
void CutCover::separate(const std::vector<int>& cut, std::vector<Side>& side) {
  for (int v : cut) {
    if (side[at(v)] != Side::lower_cut || match(v, side)) continue;
    for (int met : lower_met_) side[at(met)] = Side::lower;
    for (int met : upper_met_) side[at(met)] = Side::separator;
  }
  for (int v : cut) {
    partner_[at(v)] = -1;
    if (side[at(v)] == Side::lower_cut) side[at(v)] = Side::separator;
    if (side[at(v)] == Side::upper_cut) side[at(v)] = Side::upper;
  }
}

/// Searches, breadth first, for a path from a lower vertex to an upper one without partner that takes turns between
/// edges outside and inside the matching; exchanges them along it.
bool CutCover::match(int vertex, const std::vector<Side>& side) {
  ++search_;
  lower_met_ = {vertex};
  upper_met_.clear();
  for (std::size_t next = 0; next < lower_met_.size(); ++next) {
    const int lower = lower_met_[next];
    for (int i = graph_.start[at(lower)]; i < graph_.start[at(lower) + 1]; ++i) {
      int upper = graph_.neighbors[at(i)];
      if (side[at(upper)] != Side::upper_cut || seen_[at(upper)] == search_) continue;
      seen_[at(upper)] = search_;
      via_[at(upper)] = lower;
      upper_met_.push_back(upper);
      if (partner_[at(upper)] != -1) {
        lower_met_.push_back(partner_[at(upper)]);
        continue;
      }
      while (upper != -1) {
        const int from = via_[at(upper)];
        partner_[at(upper)] = from;
        upper = std::exchange(partner_[at(from)], upper);
      }
      return true;
    }
  }
  return false;
}

}  // namespace wirewarp
