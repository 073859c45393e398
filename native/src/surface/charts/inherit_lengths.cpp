// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/chart.h"

namespace wirewarp {

void inherit_lengths(const Chart& parent, Chart& chart) {
  chart.length_ratio.clear();
  if (parent.length_ratio.empty()) return;
  chart.length_ratio.assign(chart.mesh.n_edges(), 1);
  for (const FaceHandle f : chart.mesh.faces()) {
    HalfedgeHandle h = chart.mesh.halfedge_handle(f);
    HalfedgeHandle there = parent.mesh.halfedge_handle(FaceHandle(chart.source_face[f.idx()]));
    for (int k = 0; k < 3; ++k) {
      chart.length_ratio[chart.mesh.edge_handle(h).idx()] = length_ratio(parent, there);
      h = chart.mesh.next_halfedge_handle(h);
      there = parent.mesh.next_halfedge_handle(there);
    }
  }
}

}  // namespace wirewarp
