// SPDX-License-Identifier: GPL-3.0-or-later
#include "charts/wire_parts.h"

#include <algorithm>
#include <cmath>

#include "index.h"

namespace wirewarp {
namespace {

WireKind kind_of(double tolerance) {
  if (tolerance == 0) return WireKind::rigid;
  return std::isinf(tolerance) ? WireKind::super_elastic : WireKind::elastic;
}

/// The wire's vertices; a closed wire turned to begin on the outline, where it is cut anyway.
std::vector<int> start_on_outline(std::vector<int> vertices, const Outline& outline) {
  if (vertices.front() != vertices.back()) return vertices;
  vertices.pop_back();
  const auto on_outline = [&](int v) { return outline.is_on_outline[at(v)] != 0; };
  const auto first = std::find_if(vertices.begin(), vertices.end(), on_outline);
  if (first != vertices.end()) std::rotate(vertices.begin(), first, vertices.end());
  vertices.push_back(vertices.front());
  return vertices;
}

/// Runs of a wire: [begin, end) of its edges, all inside or all on the outline.
struct Run {
  int begin;
  int end;
  bool is_outline;
};

std::vector<Run> split_into_runs(const std::vector<int>& vertices, const EdgeTable& edges, const SurfaceCut& cut,
                                 const Outline& outline) {
  std::vector<Run> runs;
  for (int i = 0; i + 1 < static_cast<int>(vertices.size()); ++i) {
    const int v = vertices[at(i)];
    const bool is_outline = cut.is_outline(edges, edges.find(v, vertices[at(i + 1)]));
    const bool is_cut = is_outline ? outline.is_junction[at(v)] != 0 : outline.is_on_outline[at(v)] != 0;
    if (i == 0 || is_cut || is_outline != runs.back().is_outline) runs.push_back({i, i, is_outline});
    runs.back().end = i + 1;
  }
  return runs;
}

/// One chart's half-edges along a run, beginning at a side of the run's first edge.
HalfEdgeChain follow_run(const std::vector<int>& vertices, const Run& run, int first_side, const EdgeTable& edges,
                         const SurfaceCut& cut, const std::vector<HalfedgeHandle>& half_edge_of_side,
                         const HalfEdgeMesh& mesh) {
  const auto fan = [&](int side, int vertex) {
    const int corner = edges.from(side) == vertex ? side : side - side % 3 + (side + 1) % 3;
    return cut.fan_of_corner[at(corner)];
  };
  HalfEdgeChain chain;
  int side = first_side;
  for (int i = run.begin; i < run.end; ++i) {
    const int v = vertices[at(i)];
    if (i > run.begin) {
      const int reached = fan(side, v);
      const int edge = edges.find(v, vertices[at(i + 1)]);
      for (int j = 0; j < edges.num_sides(edge); ++j) {
        if (fan(edges.side(edge, j), v) == reached) side = edges.side(edge, j);
      }
    }
    const HalfedgeHandle h = half_edge_of_side[at(side)];
    chain.push_back(edges.from(side) == v ? h : mesh.opposite_halfedge_handle(h));
  }
  return chain;
}

}  // namespace

void assign_wire_parts(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut, const Outline& outline,
                       const std::vector<HalfedgeHandle>& half_edge_of_side, std::vector<Chart>& charts) {
  for (int w = 0; w < static_cast<int>(input.wires.size()); ++w) {
    const Wire& wire = input.wires[at(w)];
    const std::vector<int> vertices = start_on_outline(wire.vertices, outline);
    const std::vector<Run> runs = split_into_runs(vertices, edges, cut, outline);
    for (int part = 0; part < static_cast<int>(runs.size()); ++part) {
      const Run& run = runs[at(part)];
      const int edge = edges.find(vertices[at(run.begin)], vertices[at(run.begin + 1)]);
      std::vector<int> seen_charts;
      for (int j = 0; j < edges.num_sides(edge); ++j) {
        const int side = edges.side(edge, j);
        const int c = cut.chart_of_face[at(side / 3)];
        if (charts[at(c)].error || std::find(seen_charts.begin(), seen_charts.end(), c) != seen_charts.end()) continue;
        seen_charts.push_back(c);
        WirePart wire_part;
        wire_part.wire_index = w;
        wire_part.part = part;
        wire_part.kind = run.is_outline ? WireKind::boundary : kind_of(wire.tolerance);
        wire_part.tolerance = run.is_outline ? 0 : wire.tolerance;
        wire_part.half_edges = follow_run(vertices, run, side, edges, cut, half_edge_of_side, charts[at(c)].mesh);
        charts[at(c)].wire_parts.push_back(std::move(wire_part));
      }
    }
  }
}

}  // namespace wirewarp
