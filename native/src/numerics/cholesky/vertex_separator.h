// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

/// Where a vertex is while the set it belongs to is halved. A cut vertex has neighbors in the other half.
enum class Side : char { outside, lower, lower_cut, upper, upper_cut, separator };

/// The fewest vertices that meet all edges across a cut. By König's theorem they are as many as the edges of a largest
/// matching of those edges (D. König, Graphok és mátrixok, 1931), and found with it.
class VertexSeparator {
 public:
  explicit VertexSeparator(const Graph& graph);

  /// Makes cut vertices of both halves separator, lower or upper, so that no lower one is the neighbor of an upper one.
  /// cut: those of both halves.
  void separate(const std::vector<int>& cut, std::vector<Side>& side);

 private:
  bool match(int vertex, const std::vector<Side>& side);

  const Graph& graph_;
  std::vector<int> partner_;  // in the matching, or -1
  std::vector<int> via_;      // the lower vertex from which a search met an upper one
  std::vector<int> seen_;     // the last search that did
  int search_ = 0;
  std::vector<int> lower_met_, upper_met_;  // by the present search
};

}  // namespace wirewarp
