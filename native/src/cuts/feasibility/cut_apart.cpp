// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/cut_apart.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "surface/charts/cut_into_charts.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Returns the cut edges and the outline. Without the outline, the two sides of a slit of one edge inside the chart
/// would be merged, because both sides have the same ends.
VertexPairs cut_and_outline(const HalfEdgeMesh& mesh, const CutMask& cut) {
  std::vector<VertexPair> edges;
  for (const EdgeHandle e : mesh.edges()) {
    if (!cut[e.idx()] && !mesh.is_boundary(e)) continue;
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    edges.push_back({mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx()});
  }
  return as_pairs(edges);
}

Wire wire_of(const HalfEdgeMesh& mesh, const WirePart& part) {
  Wire wire{{}, part.tolerance, {}, part.ease};
  if (part.kind == WireKind::super_elastic) wire.tolerance = std::numeric_limits<double>::infinity();
  for (const VertexHandle v : vertices_along(mesh, part.half_edges)) wire.vertices.push_back(v.idx());
  return wire;
}

FlattenInput as_input(const Chart& chart, const CutMask& cut) {
  FlattenInput input{points_of(chart.mesh), triangles_of(chart.mesh), cut_and_outline(chart.mesh, cut), {}};
  for (const WirePart& part : chart.wire_parts) input.wires.push_back(wire_of(chart.mesh, part));
  return input;
}

std::vector<Chart> charts_of(const FlattenInput& input) {
  return cut_into_charts(input, EdgeTable(input.faces, static_cast<int>(input.vertices.rows()))).charts;
}

}  // namespace

std::vector<Chart> cut_apart(const Chart& chart, const CutMask& cut) {
  std::vector<Chart> pieces = charts_of(as_input(chart, cut));
  for (Chart& piece : pieces) {
    if (!piece.error) inherit_lengths(chart, piece);
  }
  return pieces;
}

Chart renumbered(const Chart& chart, const std::vector<VertexHandle>& vertices, const std::vector<FaceHandle>& faces) {
  const FlattenInput given = as_input(chart, CutMask(chart.mesh.n_edges(), 0));
  std::vector<int> place(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i].idx()] = static_cast<int>(i);
  const auto place_of = [&](int v) { return place[v]; };
  FlattenInput input = given;
  input.seams = given.seams.unaryExpr(place_of);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    input.vertices.row(static_cast<Eigen::Index>(i)) = given.vertices.row(vertices[i].idx());
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Eigen::RowVector3i corners = given.faces.row(faces[i].idx()).unaryExpr(place_of);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    input.faces.row(static_cast<Eigen::Index>(i)) = corners;
  }
  for (Wire& wire : input.wires)
    std::transform(wire.vertices.begin(), wire.vertices.end(), wire.vertices.begin(), place_of);
  Chart result = std::move(charts_of(input).front());
  for (int& v : result.source_vertex) v = vertices[v].idx();
  for (int& f : result.source_face) f = faces[f].idx();
  if (!chart.length_ratio.empty()) result.length_ratio.assign(result.mesh.n_edges(), 1);
  for (std::size_t e = 0; e < result.length_ratio.size(); ++e) {
    const auto [a, b] = source_edge(result, result.mesh.halfedge_handle(EdgeHandle(static_cast<int>(e)), 0));
    result.length_ratio[e] = length_ratio(chart, chart.mesh.find_halfedge(VertexHandle(a), VertexHandle(b)));
  }
  return result;
}

}  // namespace wirewarp
