// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/part_map.h"

#include <algorithm>

namespace wirewarp {

PartMap::PartMap(const Chart& chart) : num_edges_(chart.mesh.n_edges()) {
  for (const EdgeHandle e : chart.mesh.edges()) {
    if (!chart.mesh.is_boundary(e)) edges_.emplace_back(source_edge(chart, chart.mesh.halfedge_handle(e, 0)), e);
  }
  std::sort(edges_.begin(), edges_.end());
}

EdgeHandle PartMap::edge_between(const VertexPair& ends) const {
  const auto found = std::lower_bound(edges_.begin(), edges_.end(), std::pair(sorted(ends), EdgeHandle(0)));
  return found != edges_.end() && found->first == sorted(ends) ? found->second : EdgeHandle();
}

CutMask PartMap::mask_of(const std::vector<VertexPair>& edges) const {
  CutMask mask(num_edges_, 0);
  for (const VertexPair& ends : edges) {
    const EdgeHandle e = edge_between(ends);
    if (e.is_valid()) mask[e.idx()] = 1;
  }
  return mask;
}

CutMask PartMap::on_chart(const Chart& part, const CutMask& cut) const {
  CutMask mask(num_edges_, 0);
  for (const EdgeHandle e : part.mesh.edges()) {
    if (cut[e.idx()] == 0) continue;
    mask[edge_between(source_edge(part, part.mesh.halfedge_handle(e, 0))).idx()] = 1;
  }
  return mask;
}

CutMask PartMap::on_part(const Chart& part, const CutMask& cut) const {
  CutMask mask(part.mesh.n_edges(), 0);
  for (const EdgeHandle e : part.mesh.edges()) {
    if (part.mesh.is_boundary(e)) continue;
    mask[e.idx()] = cut[edge_between(source_edge(part, part.mesh.halfedge_handle(e, 0))).idx()];
  }
  return mask;
}

}  // namespace wirewarp
