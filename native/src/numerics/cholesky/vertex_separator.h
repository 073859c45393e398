// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

/// The role of a vertex when its set is halved. A cut vertex has neighbors in the other half.
enum class Side : char { outside, lower, lower_cut, upper, upper_cut, separator };

/// Finds the smallest set of vertices that contains an end of every edge across a cut. A maximum matching of these
/// edges determines the set (König, Graphok és mátrixok, 1931).
class VertexSeparator {
 public:
  explicit VertexSeparator(const Graph& graph);

  /// Turns the cut vertices of both halves into separator, lower or upper vertices, so that no lower vertex has an
  /// upper neighbor. cut: the cut vertices of both halves.
  void separate(const std::vector<int>& cut, std::vector<Side>& side);

 private:
  bool match(int vertex, const std::vector<Side>& side);

  const Graph& graph_;
  std::vector<int> partner_;  // partner in the matching; -1: none
  std::vector<int> via_;      // the lower vertex from which a search reached an upper vertex
  std::vector<int> seen_;     // the last search that reached the vertex
  int search_ = 0;
  std::vector<int> lower_met_, upper_met_;  // visited by the current search
};

}  // namespace wirewarp
