// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/cut_mask.h"

#include <algorithm>

#include "surface/mesh/geometry.h"

namespace wirewarp {

CutMask cut_along(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& half_edges) {
  CutMask cut(mesh.n_edges(), 0);
  for (const HalfedgeHandle h : half_edges) cut[mesh.edge_handle(h).idx()] = 1;
  return cut;
}

bool is_empty(const CutMask& cut) { return std::find(cut.begin(), cut.end(), 1) == cut.end(); }

void unite(CutMask& cut, const CutMask& other) {
  for (std::size_t e = 0; e < cut.size(); ++e) cut[e] = cut[e] != 0 || other[e] != 0;
}

std::vector<VertexPair> edges_of(const Chart& chart, const CutMask& cut) {
  std::vector<VertexPair> edges;
  for (const EdgeHandle e : chart.mesh.edges()) {
    if (cut[e.idx()] != 0) edges.push_back(source_edge(chart, chart.mesh.halfedge_handle(e, 0)));
  }
  return edges;
}

std::vector<VertexPair> outline_of(const Chart& chart) {
  std::vector<VertexPair> edges;
  for (const EdgeHandle e : chart.mesh.edges()) {
    if (chart.mesh.is_boundary(e)) edges.push_back(source_edge(chart, chart.mesh.halfedge_handle(e, 0)));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut) {
  double length = 0;
  for (const EdgeHandle e : mesh.edges()) {
    if (cut[e.idx()]) length += edge_length(mesh, mesh.halfedge_handle(e, 0));
  }
  return length;
}

PathRules around(const HalfEdgeMesh& mesh, const CutMask& forbidden) {
  return {[&](HalfedgeHandle h) { return forbidden[mesh.edge_handle(h).idx()] == 0; }, {}};
}

}  // namespace wirewarp
