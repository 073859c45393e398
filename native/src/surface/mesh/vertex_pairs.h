// SPDX-License-Identifier: GPL-3.0-or-later
// Converts edges between lists of vertex pairs, rows of an array, and sets that contain each edge once.
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

inline VertexPair sorted(const VertexPair& ends) { return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])}; }

/// Returns each edge once, the smaller end first.
inline std::set<VertexPair> undirected(const std::vector<VertexPair>& edges) {
  std::set<VertexPair> pairs;
  for (const VertexPair& edge : edges) pairs.insert(sorted(edge));
  return pairs;
}

inline std::vector<VertexPair> as_list(const VertexPairs& pairs) {
  std::vector<VertexPair> list;
  for (const auto& ends : pairs.rowwise()) list.push_back({ends[0], ends[1]});
  return list;
}

inline VertexPairs as_pairs(const std::vector<VertexPair>& list) {
  VertexPairs pairs(static_cast<Eigen::Index>(list.size()), 2);
  for (std::size_t i = 0; i < list.size(); ++i) pairs.row(static_cast<Eigen::Index>(i)) << list[i][0], list[i][1];
  return pairs;
}

}  // namespace wirewarp
