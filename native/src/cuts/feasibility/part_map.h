// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Converts cuts between a chart and its parts. Two edges are the same if their ends have the same source vertices.
class PartMap {
 public:
  explicit PartMap(const Chart& chart);

  /// Returns the inner edge of the chart between two source vertices, in either order. The handle is invalid if there
  /// is no such edge.
  EdgeHandle edge_between(const VertexPair& ends) const;

  /// Returns the mask of all given edges that are inner edges of the chart. edges: source vertices of each edge.
  CutMask mask_of(const std::vector<VertexPair>& edges) const;

  CutMask on_chart(const Chart& part, const CutMask& cut) const;

  /// Leaves out the edges of the cut that are outside the part.
  CutMask on_part(const Chart& part, const CutMask& cut) const;

 private:
  std::vector<std::pair<VertexPair, EdgeHandle>> edges_;  // inner edges, sorted
  std::size_t num_edges_;
};

}  // namespace wirewarp
