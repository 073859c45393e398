// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/cut_mask.h"

#include "mesh/geometry.h"

namespace wirewarp {

CutMask cut_along(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& half_edges) {
  CutMask cut(mesh.n_edges(), 0);
  for (const HalfedgeHandle h : half_edges) cut[mesh.edge_handle(h).idx()] = 1;
  return cut;
}

double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut) {
  double length = 0;
  for (const EdgeHandle e : mesh.edges()) {
    if (cut[e.idx()]) length += edge_length(mesh, mesh.halfedge_handle(e, 0));
  }
  return length;
}

PathRules around(const HalfEdgeMesh& mesh, const CutMask& barred) {
  return {[&](HalfedgeHandle h) { return barred[mesh.edge_handle(h).idx()] == 0; }, {}};
}

}  // namespace wirewarp
