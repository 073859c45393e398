// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/wire_parts.h"

#include <algorithm>
#include <cmath>

namespace wirewarp {
namespace {

/// A run of a wire: the edges [begin, end) of the wire, all inside a chart or all on the outline.
struct Run {
  int begin;
  int end;
  bool is_outline;
};

/// Splits the vertices of a wire into runs. First rotates the list of a closed wire to the lowest vertex at which a run
/// begins, so that the runs do not depend on the start of the list.
std::vector<Run> split_into_runs(std::vector<int>& vertices, const EdgeTable& edges, const SurfaceCut& cut,
                                 const Outline& outline) {
  const bool is_closed = vertices.front() == vertices.back();
  const int num_edges = static_cast<int>(vertices.size()) - 1;
  std::vector<int> wire_edges;
  for (int i = 0; i < num_edges; ++i) wire_edges.push_back(edges.find(vertices[i], vertices[i + 1]));
  const auto is_outline = [&](int i) { return cut.is_outline(edges, wire_edges[i]); };
  const auto fan_at = [&](int i, int vertex) {
    return cut.fan_of_corner[edges.corner_at(edges.side(wire_edges[i], 0), vertex)];
  };
  const auto begins_run = [&](int i) {
    const int before = i > 0 ? i - 1 : is_closed ? num_edges - 1 : i;
    const int v = vertices[i];
    if (is_outline(before) != is_outline(i)) return true;
    if (is_outline(i)) return outline.is_junction[v] != 0;
    // A run also begins where the wire passes to a chart that touches the previous chart only at this vertex.
    return outline.is_on_outline[v] != 0 || fan_at(before, v) != fan_at(i, v);
  };
  if (is_closed) {
    int first = -1;
    for (int i = 0; i < num_edges; ++i) {
      if (begins_run(i) && (first < 0 || vertices[i] < vertices[first])) first = i;
    }
    if (first > 0) {
      vertices.pop_back();
      std::rotate(vertices.begin(), vertices.begin() + first, vertices.end());
      std::rotate(wire_edges.begin(), wire_edges.begin() + first, wire_edges.end());
      vertices.push_back(vertices.front());
    }
  }
  std::vector<Run> runs;
  for (int i = 0; i < num_edges; ++i) {
    if (i == 0 || begins_run(i)) runs.push_back({i, i, is_outline(i)});
    runs.back().end = i + 1;
  }
  return runs;
}

/// Returns one chart's half-edges along a run, starting at a side of the run's first edge.
HalfEdgeChain follow_run(const std::vector<int>& vertices, const Run& run, int first_side, const EdgeTable& edges,
                         const SurfaceCut& cut, const std::vector<HalfedgeHandle>& half_edge_of_side,
                         const HalfEdgeMesh& mesh) {
  const auto fan = [&](int side, int vertex) { return cut.fan_of_corner[edges.corner_at(side, vertex)]; };
  HalfEdgeChain chain;
  int side = first_side;
  for (int i = run.begin; i < run.end; ++i) {
    const int v = vertices[i];
    if (i > run.begin) {
      const int reached = fan(side, v);
      const int edge = edges.find(v, vertices[i + 1]);
      for (int j = 0; j < edges.num_sides(edge); ++j) {
        if (fan(edges.side(edge, j), v) == reached) side = edges.side(edge, j);
      }
    }
    const HalfedgeHandle h = half_edge_of_side[side];
    chain.push_back(edges.from(side) == v ? h : mesh.opposite_halfedge_handle(h));
  }
  return chain;
}

/// Multiplies a target length. Does nothing for ratio 1, so that length_ratio stays empty in charts that keep all
/// lengths.
void multiply_length(Chart& chart, HalfedgeHandle h, double ratio) {
  if (ratio == 1) return;
  chart.length_ratio.resize(chart.mesh.n_edges(), 1);
  chart.length_ratio[static_cast<std::size_t>(chart.mesh.edge_handle(h).idx())] *= ratio;
}

}  // namespace

WireKind kind_of(double tolerance) {
  if (tolerance == 0) return WireKind::rigid;
  return std::isinf(tolerance) ? WireKind::super_elastic : WireKind::elastic;
}

std::vector<char> assign_wire_parts(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut,
                                    const Outline& outline, const std::vector<HalfedgeHandle>& half_edge_of_side,
                                    std::vector<Chart>& charts) {
  std::vector<char> is_boundary_wire;
  for (int w = 0; w < static_cast<int>(input.wires.size()); ++w) {
    const Wire& wire = input.wires[w];
    std::vector<int> vertices = wire.vertices;
    const std::vector<Run> runs = split_into_runs(vertices, edges, cut, outline);
    is_boundary_wire.push_back(std::all_of(runs.begin(), runs.end(), [](const Run& run) { return run.is_outline; }));
    for (int part = 0; part < static_cast<int>(runs.size()); ++part) {
      const Run& run = runs[part];
      const int edge = edges.find(vertices[run.begin], vertices[run.begin + 1]);
      for (int j = 0; j < (run.is_outline ? edges.num_sides(edge) : 1); ++j) {
        const int side = edges.side(edge, j);
        Chart& chart = charts[cut.chart_of_face[side / 3]];
        if (chart.error) continue;
        WirePart wire_part;
        wire_part.wire_index = w;
        wire_part.part = part;
        wire_part.kind = run.is_outline ? WireKind::boundary : kind_of(wire.tolerance);
        wire_part.tolerance = wire.tolerance;
        wire_part.ease = wire.ease;
        wire_part.half_edges = follow_run(vertices, run, side, edges, cut, half_edge_of_side, chart.mesh);
        for (const HalfedgeHandle h : wire_part.half_edges) multiply_length(chart, h, 1 + wire.ease);
        chart.wire_parts.push_back(std::move(wire_part));
      }
    }
  }
  return is_boundary_wire;
}

void assign_eases(const std::vector<Ease>& eases, const EdgeTable& edges, const SurfaceCut& cut,
                  const std::vector<HalfedgeHandle>& half_edge_of_side, std::vector<Chart>& charts) {
  for (const Ease& ease : eases) {
    for (const auto& ends : ease.half_edges.rowwise()) {
      const int edge = edges.find(ends[0], ends[1]);
      for (int j = 0; j < edges.num_sides(edge); ++j) {
        const int side = edges.side(edge, j);
        Chart& chart = charts[cut.chart_of_face[side / 3]];
        if (edges.from(side) == ends[0] && !chart.error)
          multiply_length(chart, half_edge_of_side[side], 1 + ease.ratio);
      }
    }
  }
}

}  // namespace wirewarp
