// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/slits.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/disjoint_sets.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Returns for each half-edge the index of the other half-edge on the same input edge. Returns nullopt unless the loop
/// has two half-edges on each of its edges.
std::optional<std::vector<int>> find_mates(const Chart& chart, const HalfEdgeChain& loop) {
  std::map<VertexPair, int> first;
  std::vector<int> mate(loop.size(), -1);
  for (int i = 0; i < static_cast<int>(loop.size()); ++i) {
    const auto [other, is_first] = first.try_emplace(source_edge(chart, loop[i]), i);
    if (is_first) continue;
    if (mate[other->second] >= 0) return std::nullopt;
    mate[other->second] = i;
    mate[i] = other->second;
  }
  const bool is_matched = std::find(mate.begin(), mate.end(), -1) == mate.end();
  return is_matched ? std::optional(mate) : std::nullopt;
}

/// Returns the index of a half-edge that leaves a tip, where the rims turn back; nullopt if there is no tip.
std::optional<int> find_tip(const std::vector<int>& mate) {
  const int count = static_cast<int>(mate.size());
  for (int i = 0; i < count; ++i) {
    if (mate[i] == (i + count - 1) % count) return i;
  }
  return std::nullopt;
}

std::vector<int> vertices_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& chain, const std::vector<int>& label) {
  std::vector<int> vertices;
  for (const VertexHandle v : vertices_along(mesh, chain)) vertices.push_back(label[v.idx()]);
  return vertices;
}

/// Returns the edges of a slit, each once, as chains along its rims.
std::vector<HalfEdgeChain> chains_of(const Slit& slit) {
  std::vector<HalfEdgeChain> chains;
  bool goes_on = false;
  for (int i = 0; i < static_cast<int>(slit.rims.size()); ++i) {
    const bool is_new = i < slit.mate[i];
    if (is_new && !goes_on) chains.emplace_back();
    if (is_new) chains.back().push_back(slit.rims[i]);
    goes_on = is_new;
  }
  return chains;
}

/// Makes the outer loop of the chart also the outer loop of the sewn chart. Without this function, it might be another
/// loop, because merging vertices changes how much the loops turn.
void keep_outer_loop(const Chart& chart, SewnChart& sewn) {
  const HalfedgeHandle there = sewn_half_edge(chart, sewn, chart.boundary_loops.front().front());
  std::vector<HalfEdgeChain>& loops = sewn.chart.boundary_loops;
  const auto outer = std::find_if(loops.begin(), loops.end(), [&](const HalfEdgeChain& loop) {
    return std::find(loop.begin(), loop.end(), there) != loop.end();
  });
  if (outer == loops.end()) throw std::logic_error("sewing slits closed the outer loop");
  std::iter_swap(loops.begin(), outer);
}

}  // namespace

HalfedgeHandle sewn_half_edge(const Chart& chart, const SewnChart& sewn, HalfedgeHandle h) {
  const auto sewn_end = [&](VertexHandle v) { return VertexHandle(sewn.vertex[v.idx()]); };
  return sewn.chart.mesh.find_halfedge(sewn_end(chart.mesh.from_vertex_handle(h)),
                                       sewn_end(chart.mesh.to_vertex_handle(h)));
}

std::optional<Slit> as_slit(const Chart& chart, const HalfEdgeChain& loop) {
  Slit slit{loop, {}};
  const std::optional<std::vector<int>> mate = find_mates(chart, slit.rims);
  const std::optional<int> tip = mate ? find_tip(*mate) : std::nullopt;
  if (!tip) return std::nullopt;
  std::rotate(slit.rims.begin(), slit.rims.begin() + *tip, slit.rims.end());
  slit.mate = *find_mates(chart, slit.rims);
  return slit;
}

std::vector<Slit> find_slits(const Chart& chart) {
  std::vector<char> is_elastic(chart.mesh.n_edges(), 0);
  for (const WirePart& part : chart.wire_parts) {
    if (!is_elastic_boundary(part)) continue;
    for (const HalfedgeHandle h : part.half_edges) is_elastic[chart.mesh.edge_handle(h).idx()] = 1;
  }
  const auto has_other_target = [&](HalfedgeHandle h) {
    return is_elastic[chart.mesh.edge_handle(h).idx()] != 0 || length_ratio(chart, h) != 1;
  };
  std::vector<Slit> slits;
  for (std::size_t l = 1; l < chart.boundary_loops.size(); ++l) {
    const bool is_eased = std::any_of(chart.boundary_loops[l].begin(), chart.boundary_loops[l].end(), has_other_target);
    std::optional<Slit> slit = is_eased ? std::nullopt : as_slit(chart, chart.boundary_loops[l]);
    if (slit) slits.push_back(std::move(*slit));
  }
  return slits;
}

std::optional<SewnChart> sew(const Chart& chart, const std::vector<Slit>& slits) {
  const HalfEdgeMesh& mesh = chart.mesh;
  DisjointSets vertices(mesh.n_vertices());
  for (const Slit& slit : slits) {
    for (std::size_t i = 0; i < slit.rims.size(); ++i) {
      const HalfedgeHandle one = slit.rims[i], other = slit.rims[slit.mate[i]];
      vertices.unite(mesh.from_vertex_handle(one).idx(), mesh.to_vertex_handle(other).idx());
    }
  }
  SewnChart sewn;
  int num_vertices = 0;
  sewn.vertex = vertices.number(num_vertices);

  FlattenInput surface;
  surface.vertices.resize(num_vertices, 3);
  const Positions3 points = points_of(mesh);
  for (int v = 0; v < points.rows(); ++v) surface.vertices.row(sewn.vertex[v]) = points.row(v);
  surface.faces = triangles_of(mesh).unaryExpr([&](int v) { return sewn.vertex[v]; });
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind == WireKind::boundary) continue;
    surface.wires.push_back({vertices_of(mesh, part.half_edges, sewn.vertex), part.tolerance, {}, part.ease});
  }
  for (const Slit& slit : slits) {
    for (const HalfEdgeChain& chain : chains_of(slit)) {
      surface.wires.push_back({vertices_of(mesh, chain, sewn.vertex), 0, {}});
    }
  }
  const EdgeTable edges(surface.faces, num_vertices);
  Charts charts = cut_into_charts(surface, edges);
  const bool is_whole = charts.charts.size() == 1 && !charts.charts[0].error;
  if (!is_whole || static_cast<int>(charts.charts[0].mesh.n_vertices()) != num_vertices) return std::nullopt;
  sewn.chart = std::move(charts.charts[0]);
  // The rims of an edge that stays open can become one edge, for example on a closed surface. Then a loop is missing,
  // and the slits cannot be sewn.
  if (sewn.chart.boundary_loops.size() + slits.size() != chart.boundary_loops.size()) return std::nullopt;
  keep_outer_loop(chart, sewn);
  inherit_lengths(chart, sewn.chart);
  for (const WirePart& part : chart.wire_parts) {
    if (!is_elastic_boundary(part)) continue;
    sewn.chart.wire_parts.push_back(part);
    for (HalfedgeHandle& h : sewn.chart.wire_parts.back().half_edges) h = sewn_half_edge(chart, sewn, h);
  }
  return sewn;
}

}  // namespace wirewarp
