// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/lengths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "surface/charts/wire_parts.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct ChainLength {
  double length_3d = 0;
  double length_2d = 0;
  double max_edge_error = 0;
};

/// Returns the guaranteed flat length (1 + r)(1 + h) l of each edge of the chart, where l is the length on the surface
/// and r the ease of the side. variation: h, one per wire part.
std::vector<double> guaranteed_lengths(const Chart& chart, const std::vector<double>& variation) {
  std::vector<double> lengths;
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    lengths.push_back(length_ratio(chart, h) * edge_length(chart.mesh, h));
  }
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    for (const HalfedgeHandle h : part.half_edges) {
      lengths[chart.mesh.edge_handle(h).idx()] *= (1 + variation[i]) / (1 + part.ease);
    }
  }
  return lengths;
}

ChainLength measure_chain(const Chart& chart, const HalfEdgeChain& chain, const Positions2& uv,
                          const std::vector<double>& guaranteed) {
  ChainLength result;
  for (const HalfedgeHandle half_edge : chain) {
    const double length = edge_length(chart.mesh, half_edge);
    const double planar = planar_length(chart.mesh, half_edge, uv);
    const double error = std::abs(planar - guaranteed[chart.mesh.edge_handle(half_edge).idx()]) / length;
    result.length_3d += length;
    result.length_2d += planar;
    result.max_edge_error = std::max(result.max_edge_error, error);
  }
  return result;
}

/// Returns the eases r of single sides, keyed by directed edge.
std::map<VertexPair, double> list_side_eases(const std::vector<Ease>& eases) {
  std::map<VertexPair, double> ratios;
  for (const Ease& ease : eases) {
    for (const auto& ends : ease.half_edges.rowwise()) ratios[{ends[0], ends[1]}] = ease.ratio;
  }
  return ratios;
}

/// The lengths of one side of a seam: sums over its edges. l: length on the surface; l2: flat length; h, r: as in
/// SeamReport.
struct SideLength {
  double unstretched = 0;   // l
  double shared = 0;        // (1 + h) l
  double guaranteed = 0;    // (1 + r)(1 + h) l
  double without_ease = 0;  // l2 / (1 + r)
};

SideLength measure_side(const Chart& chart, const HalfEdgeChain& chain, const Piece& piece,
                        const std::vector<double>& guaranteed, const std::map<VertexPair, double>& side_eases) {
  SideLength side;
  for (const HalfedgeHandle h : chain) {
    const auto ease = side_eases.find(source_ends(chart, h));
    const double ratio = ease == side_eases.end() ? 1 : 1 + ease->second;
    side.unstretched += edge_length(chart.mesh, h);
    side.shared += guaranteed[chart.mesh.edge_handle(h).idx()] / ratio;
    side.guaranteed += guaranteed[chart.mesh.edge_handle(h).idx()];
    side.without_ease += planar_length(chart.mesh, h, piece.vertices) / ratio;
  }
  return side;
}

double distance(const Positions3& vertices, int a, int b) { return (vertices.row(a) - vertices.row(b)).norm(); }

std::vector<int> source_vertices(const Chart& chart, const HalfEdgeChain& chain) {
  std::vector<int> vertices;
  for (const VertexHandle v : vertices_along(chart.mesh, chain)) vertices.push_back(chart.source_vertex[v.idx()]);
  return vertices;
}

/// The lengths of the edges of one wire in all pieces.
struct WireEdges {
  struct Edge {
    double length_2d;
    double intended;  // (1 + h) l
  };
  std::map<VertexPair, Edge> edges;  // keyed by input vertices; from the first piece that has the edge
  double max_edge_error = 0;
};

void collect_part(const Chart& chart, const WirePart& part, const WireReport& report, const Positions2& uv,
                  WireEdges& wire) {
  for (const HalfedgeHandle h : part.half_edges) {
    wire.edges.insert({source_edge(chart, h),
                       {planar_length(chart.mesh, h, uv), (1 + report.variation) * edge_length(chart.mesh, h)}});
  }
  wire.max_edge_error = std::max(wire.max_edge_error, report.max_edge_error);
}

WireReport measure_whole_wire(const Wire& wire, bool is_boundary, const WireEdges& known, const Positions3& vertices) {
  WireReport report;
  report.name = wire.name;
  report.tolerance = wire.tolerance;
  report.kind = is_boundary ? WireKind::boundary : kind_of(wire.tolerance);
  double intended = 0;
  for (std::size_t i = 0; i + 1 < wire.vertices.size(); ++i) {
    const int a = wire.vertices[i];
    const int b = wire.vertices[i + 1];
    report.length_3d += distance(vertices, a, b);
    const auto edge = known.edges.find(sorted({a, b}));
    report.length_2d += edge == known.edges.end() ? kUnknown : edge->second.length_2d;
    intended += edge == known.edges.end() ? kUnknown : edge->second.intended;
  }
  report.variation = intended / report.length_3d - 1;
  report.max_edge_error = std::isnan(intended) ? kUnknown : known.max_edge_error;
  report.vertices = wire.vertices;
  return report;
}

bool has_layout(const Piece& piece) { return !piece.boundaries.empty(); }

}  // namespace

std::vector<WireReport> measure_wire_parts(const Chart& chart, const std::vector<Wire>& wires, const Positions2& uv,
                                           const std::vector<double>& variation) {
  const std::vector<double> guaranteed = guaranteed_lengths(chart, variation);
  std::vector<WireReport> reports;
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    const ChainLength chain = measure_chain(chart, part.half_edges, uv, guaranteed);
    reports.push_back({wires[part.wire_index].name, part.wire_index, part.part, part.kind, part.tolerance,
                       chain.length_3d, chain.length_2d, variation[i], chain.max_edge_error,
                       source_vertices(chart, part.half_edges)});
  }
  return reports;
}

std::vector<BoundaryReport> measure_boundaries(const Chart& chart, const Positions2& uv,
                                               const std::vector<double>& variation) {
  const std::vector<double> guaranteed = guaranteed_lengths(chart, variation);
  std::vector<BoundaryReport> reports;
  for (const BoundaryChain& boundary : chart.boundary_chains) {
    const ChainLength chain = measure_chain(chart, boundary.half_edges, uv, guaranteed);
    BoundaryReport report;
    report.vertices = source_vertices(chart, boundary.half_edges);
    report.length_3d = chain.length_3d;
    report.length_2d = chain.length_2d;
    report.max_edge_error = chain.max_edge_error;
    if (boundary.seam >= 0) report.seam = boundary.seam;
    reports.push_back(std::move(report));
  }
  return reports;
}

std::vector<SeamReport> measure_seams(const FlattenInput& input, const Charts& charts,
                                      const std::vector<Piece>& pieces) {
  const std::map<VertexPair, double> side_eases = list_side_eases(input.eases);
  std::vector<std::vector<double>> guaranteed(pieces.size());
  for (std::size_t c = 0; c < pieces.size(); ++c) {
    std::vector<double> variation;
    for (const WireReport& wire : pieces[c].wires) variation.push_back(wire.variation);
    if (has_layout(pieces[c])) guaranteed[c] = guaranteed_lengths(charts.charts[c], variation);
  }
  std::vector<SeamReport> reports;
  for (const Seam& seam : charts.seams) {
    SeamReport report;
    report.edges = seam.edges;
    for (const VertexPair& edge : seam.edges) report.length_3d += distance(input.vertices, edge[0], edge[1]);
    report.variation = kUnknown;
    std::vector<double> known;
    for (const Seam::Side& side : seam.sides) {
      const Piece& piece = pieces[side.chart];
      report.pieces.push_back(side.chart);
      report.length_2d.push_back(has_layout(piece) ? piece.boundaries[side.boundary_chain].length_2d : kUnknown);
      report.eases.push_back(kUnknown);
      if (!has_layout(piece)) continue;
      const Chart& chart = charts.charts[side.chart];
      const SideLength length = measure_side(chart, chart.boundary_chains[side.boundary_chain].half_edges, piece,
                                             guaranteed[side.chart], side_eases);
      known.push_back(length.without_ease);
      report.eases.back() = length.guaranteed / length.shared - 1;
      if (std::isnan(report.variation)) report.variation = length.shared / length.unstretched - 1;
    }
    const auto [shortest, longest] = std::minmax_element(known.begin(), known.end());
    report.mismatch = known.size() < 2 ? kUnknown : *longest - *shortest;
    reports.push_back(std::move(report));
  }
  return reports;
}

std::vector<WireReport> measure_whole_wires(const FlattenInput& input, const Charts& charts,
                                            const std::vector<Piece>& pieces) {
  std::vector<WireEdges> known(input.wires.size());
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    const Chart& chart = charts.charts[c];
    if (!has_layout(pieces[c])) continue;
    for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
      collect_part(chart, chart.wire_parts[i], pieces[c].wires[i], pieces[c].vertices,
                   known[chart.wire_parts[i].wire_index]);
    }
  }
  std::vector<WireReport> reports;
  for (std::size_t w = 0; w < input.wires.size(); ++w) {
    reports.push_back(measure_whole_wire(input.wires[w], charts.is_boundary_wire[w] != 0, known[w], input.vertices));
    reports.back().wire_index = static_cast<int>(w);
  }
  return reports;
}

std::vector<double> fit_variation(const Chart& chart, const Positions2& uv) {
  struct Lengths {
    double asked = 0, flat = 0;
  };
  // Sums over all sides of each boundary part in the chart, by wire and part.
  std::map<std::pair<int, int>, Lengths> sides;
  std::vector<Lengths> lengths;
  for (const WirePart& part : chart.wire_parts) {
    Lengths of_part;
    for (const HalfedgeHandle h : part.half_edges) {
      of_part.asked += length_ratio(chart, h) * edge_length(chart.mesh, h);
      of_part.flat += planar_length(chart.mesh, h, uv);
    }
    lengths.push_back(of_part);
    if (part.kind != WireKind::boundary) continue;
    Lengths& of_run = sides[{part.wire_index, part.part}];
    of_run.asked += of_part.asked;
    of_run.flat += of_part.flat;
  }
  std::vector<double> variation;
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    const Lengths& fitted = part.kind == WireKind::boundary ? sides.at({part.wire_index, part.part}) : lengths[i];
    variation.push_back(part.tolerance > 0 ? variation_of(part, fitted.flat / fitted.asked - 1) : part.ease);
  }
  return variation;
}

}  // namespace wirewarp
