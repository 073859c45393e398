// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Converts cuts between a chart, its parts, and their common source vertices.
class PartMap {
 public:
  explicit PartMap(const Chart& chart);

  /// Returns the inner edge of the chart between two source vertices, in either order; not valid if there is none.
  EdgeHandle edge_between(const VertexPair& ends) const;

  /// Returns the inner edges of the chart among these edges, given by their source vertices.
  CutMask mask_of(const std::vector<VertexPair>& edges) const;

  /// Converts a cut of a part to a cut of the chart.
  CutMask on_chart(const Chart& part, const CutMask& cut) const;

  /// Returns the part of the chart's cut that is inside a part.
  CutMask on_part(const Chart& part, const CutMask& cut) const;

 private:
  std::vector<std::pair<VertexPair, EdgeHandle>> edges_;  // inner edges, sorted
  std::size_t num_edges_;                                 // of the chart
};

}  // namespace wirewarp
