// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Carries cuts between a chart, its parts, and the vertices that all of them come from.
class PartMap {
 public:
  explicit PartMap(const Chart& chart);

  /// The inner edge of the chart between two sources, either way round; not valid if there is none.
  EdgeHandle edge_between(VertexPair ends) const;

  /// The inner edges of the chart among edges given by their sources.
  CutMask mask_of(const std::vector<VertexPair>& edges) const;

  /// A cut of a part, as a cut of the chart.
  CutMask on_chart(const Chart& part, const CutMask& cut) const;

  /// The share of a cut of the chart that lies inside a part.
  CutMask on_part(const Chart& part, const CutMask& cut) const;

 private:
  std::vector<std::pair<VertexPair, EdgeHandle>> edges_;  // the inner ones, sorted
  std::size_t num_edges_;                                 // of the chart
};

}  // namespace wirewarp
