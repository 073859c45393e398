// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/split_chart.h"

#include <limits>

namespace wirewarp {
namespace {

/// Returns the cotangent of the angle opposite to h in its face.
double opposite_cotangent(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  const auto apex = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  const auto a = mesh.point(mesh.from_vertex_handle(h)) - apex;
  const auto b = mesh.point(mesh.to_vertex_handle(h)) - apex;
  return (a | b) / (a % b).norm();
}

bool should_flip(const SplitChart& split, EdgeHandle edge) {
  // Sum of cotangents that counts as zero: far above rounding errors, so that no edge is flipped back and forth.
  constexpr double kCocircular = 1e-9;
  const HalfEdgeMesh& mesh = split.chart.mesh;
  if (split.wires.has(edge)) return false;
  const HalfedgeHandle h = mesh.halfedge_handle(edge, 0);
  const HalfedgeHandle o = mesh.halfedge_handle(edge, 1);
  const std::vector<int>& source = split.chart.source_face;
  if (source[mesh.face_handle(h).idx()] != source[mesh.face_handle(o).idx()]) return false;
  return opposite_cotangent(mesh, h) + opposite_cotangent(mesh, o) < -kCocircular && mesh.is_flip_ok(edge);
}

}  // namespace

WireMask::WireMask(const Chart& chart) {
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) add(chart.mesh, h);
  }
  for (const WirePart& part : chart.wire_parts) {
    for (const HalfedgeHandle h : part.half_edges) add(chart.mesh, h);
  }
}

void WireMask::add(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  edges_.resize(mesh.n_edges(), 0);
  vertices_.resize(mesh.n_vertices(), 0);
  edges_[mesh.edge_handle(h).idx()] = 1;
  vertices_[mesh.from_vertex_handle(h).idx()] = 1;
  vertices_[mesh.to_vertex_handle(h).idx()] = 1;
}

VertexHandle split_edge(SplitChart& split, HalfedgeHandle h, double t) {
  HalfEdgeMesh& mesh = split.chart.mesh;
  std::vector<int>& source_face = split.chart.source_face;
  const auto from = mesh.point(mesh.from_vertex_handle(h));
  const auto to = mesh.point(mesh.to_vertex_handle(h));
  const VertexHandle middle = mesh.new_vertex(from + (to - from) * t);
  split.chart.source_vertex.push_back(-1);

  // One half of each triangle remains the old face and the other half is new. The half-edges after and before h in its
  // triangle are in different halves, so they lead to both halves.
  const std::array<HalfedgeHandle, 2> sides{h, mesh.opposite_halfedge_handle(h)};
  std::array<std::array<HalfedgeHandle, 2>, 2> far_sides;
  std::array<int, 2> sources{};
  for (std::size_t i = 0; i < 2; ++i) {
    far_sides[i] = {mesh.next_halfedge_handle(sides[i]), mesh.prev_halfedge_handle(sides[i])};
    sources[i] = source_face[mesh.face_handle(sides[i]).idx()];
  }
  mesh.split(mesh.edge_handle(h), middle);
  source_face.resize(mesh.n_faces(), -1);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const HalfedgeHandle side : far_sides[i]) source_face[mesh.face_handle(side).idx()] = sources[i];
  }
  return middle;
}

void make_room(SplitChart& split, const std::vector<VertexHandle>& seeds) {
  const HalfEdgeMesh& mesh = split.chart.mesh;
  std::vector<char> is_seen(mesh.n_faces(), 0);
  std::vector<FaceHandle> stack;
  const auto visit = [&](FaceHandle f) {
    if (is_seen[f.idx()]) return;
    is_seen[f.idx()] = 1;
    stack.push_back(f);
  };
  for (const VertexHandle v : seeds) {
    for (const FaceHandle f : mesh.vf_range(v)) visit(f);
  }
  std::vector<HalfedgeHandle> narrow;
  while (!stack.empty()) {
    HalfedgeHandle h = mesh.halfedge_handle(stack.back());
    stack.pop_back();
    for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
      if (split.wires.has(mesh.edge_handle(h))) continue;
      visit(mesh.face_handle(mesh.opposite_halfedge_handle(h)));
      const bool is_first = h == mesh.halfedge_handle(mesh.edge_handle(h), 0);
      const bool joins_wires = split.wires.has(mesh.from_vertex_handle(h)) && split.wires.has(mesh.to_vertex_handle(h));
      if (is_first && joins_wires) narrow.push_back(h);
    }
  }
  for (const HalfedgeHandle h : narrow) split_edge(split, h, 0.5);
}

void add_helper_wire(SplitChart& split, HalfEdgeChain half_edges) {
  int num_helpers = 0;
  for (const WirePart& part : split.chart.wire_parts) num_helpers += part.wire_index < 0 ? 1 : 0;
  for (const HalfedgeHandle h : half_edges) split.wires.add(split.chart.mesh, h);
  split.chart.wire_parts.push_back(
      {-1, num_helpers, WireKind::super_elastic, std::numeric_limits<double>::infinity(), std::move(half_edges)});
}

void restore_delaunay(SplitChart& split, WorkMeter& work) {
  HalfEdgeMesh& mesh = split.chart.mesh;
  std::vector<EdgeHandle> stack;
  for (const EdgeHandle e : mesh.edges()) stack.push_back(e);
  // Lawson's flips terminate; the bound only protects from rounding errors at cocircular corners.
  std::size_t flips_left = 100 * mesh.n_edges();
  while (!stack.empty() && flips_left > 0) {
    const EdgeHandle edge = stack.back();
    stack.pop_back();
    work.did(1);
    if (!should_flip(split, edge)) continue;
    mesh.flip(edge);
    --flips_left;
    for (unsigned side = 0; side < 2; ++side) {
      const HalfedgeHandle h = mesh.next_halfedge_handle(mesh.halfedge_handle(edge, side));
      stack.push_back(mesh.edge_handle(h));
      stack.push_back(mesh.edge_handle(mesh.next_halfedge_handle(h)));
    }
  }
}

}  // namespace wirewarp
