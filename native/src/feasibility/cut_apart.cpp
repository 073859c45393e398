// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/cut_apart.h"

#include <limits>

#include "charts/cut_into_charts.h"
#include "mesh/geometry.h"

namespace wirewarp {
namespace {

/// The cut, and the outline: the rims of a slit of one edge have the same ends, and would be joined.
VertexPairs cut_and_outline(const HalfEdgeMesh& mesh, const CutMask& cut) {
  std::vector<VertexPair> edges;
  for (const EdgeHandle e : mesh.edges()) {
    if (!cut[e.idx()] && !mesh.is_boundary(e)) continue;
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    edges.push_back({mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx()});
  }
  VertexPairs pairs(static_cast<Eigen::Index>(edges.size()), 2);
  for (int i = 0; i < pairs.rows(); ++i) pairs.row(i) << edges[i][0], edges[i][1];
  return pairs;
}

Wire wire_of(const HalfEdgeMesh& mesh, const WirePart& part) {
  Wire wire{{mesh.from_vertex_handle(part.half_edges.front()).idx()}, part.tolerance, {}, part.ease};
  if (part.kind == WireKind::super_elastic) wire.tolerance = std::numeric_limits<double>::infinity();
  for (const HalfedgeHandle h : part.half_edges) wire.vertices.push_back(mesh.to_vertex_handle(h).idx());
  return wire;
}

}  // namespace

std::vector<Chart> cut_apart(const Chart& chart, const CutMask& cut) {
  FlattenInput input{points_of(chart.mesh), triangles_of(chart.mesh), cut_and_outline(chart.mesh, cut), {}};
  for (const WirePart& part : chart.wire_parts) input.wires.push_back(wire_of(chart.mesh, part));
  const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
  std::vector<Chart> pieces = cut_into_charts(input, edges).charts;
  for (Chart& piece : pieces) {
    if (!piece.error) inherit_lengths(chart, piece);
  }
  return pieces;
}

}  // namespace wirewarp
