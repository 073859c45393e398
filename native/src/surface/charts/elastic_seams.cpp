// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/elastic_seams.h"

#include <map>
#include <utility>

#include "base/disjoint_sets.h"

namespace wirewarp {
namespace {

void append_mesh(const HalfEdgeMesh& from, HalfEdgeMesh& mesh) {
  const auto vertex = [first = static_cast<int>(mesh.n_vertices())](VertexHandle v) {
    return VertexHandle(first + v.idx());
  };
  const auto half_edge = [first = static_cast<int>(mesh.n_halfedges())](HalfedgeHandle h) {
    return HalfedgeHandle(first + h.idx());
  };
  const auto face = [first = static_cast<int>(mesh.n_faces())](FaceHandle f) {
    return f.is_valid() ? FaceHandle(first + f.idx()) : f;
  };
  for (const VertexHandle v : from.vertices()) mesh.new_vertex(from.point(v));
  for (const EdgeHandle e : from.edges()) {
    const HalfedgeHandle h = from.halfedge_handle(e, 0);
    mesh.new_edge(vertex(from.from_vertex_handle(h)), vertex(from.to_vertex_handle(h)));
  }
  for (const FaceHandle f : from.faces()) mesh.set_halfedge_handle(mesh.new_face(), half_edge(from.halfedge_handle(f)));
  for (const VertexHandle v : from.vertices()) {
    mesh.set_halfedge_handle(vertex(v), half_edge(from.halfedge_handle(v)));
  }
  for (const HalfedgeHandle h : from.halfedges()) {
    mesh.set_next_halfedge_handle(half_edge(h), half_edge(from.next_halfedge_handle(h)));
    mesh.set_face_handle(half_edge(h), face(from.face_handle(h)));
  }
}

HalfEdgeChain moved(HalfEdgeChain chain, int first_half_edge) {
  for (HalfedgeHandle& h : chain) h = HalfedgeHandle(first_half_edge + h.idx());
  return chain;
}

}  // namespace

std::vector<std::vector<int>> group_by_elastic_seams(const std::vector<Chart>& charts) {
  DisjointSets sets(charts.size());
  std::map<std::pair<int, int>, int> first_with_run;  // keyed by wire and part
  for (int c = 0; c < static_cast<int>(charts.size()); ++c) {
    for (const WirePart& part : charts[c].wire_parts) {
      if (charts[c].error || !is_elastic_boundary(part)) continue;
      sets.unite(first_with_run.insert({{part.wire_index, part.part}, c}).first->second, c);
    }
  }
  int num_groups = 0;
  const std::vector<int> group_of_chart = sets.number(num_groups);
  std::vector<std::vector<int>> groups(static_cast<std::size_t>(num_groups));
  for (std::size_t c = 0; c < charts.size(); ++c) groups[group_of_chart[c]].push_back(static_cast<int>(c));
  return groups;
}

FixedSeams::FixedSeams(Chart& chart, const std::vector<double>& variation)
    : chart_(chart), elastic_parts_(chart.wire_parts), length_ratio_(chart.length_ratio) {
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    WirePart& part = chart.wire_parts[i];
    if (!is_elastic_boundary(part)) continue;
    chart.length_ratio.resize(chart.mesh.n_edges(), 1);
    for (const HalfedgeHandle h : part.half_edges) {
      chart.length_ratio[chart.mesh.edge_handle(h).idx()] *= (1 + variation[i]) / (1 + part.ease);
    }
    part.ease = variation[i];
    part.tolerance = 0;
  }
}

FixedSeams::~FixedSeams() {
  chart_.wire_parts.swap(elastic_parts_);
  chart_.length_ratio.swap(length_ratio_);
}

std::vector<double> eases_of(const Chart& chart) {
  std::vector<double> eases;
  for (const WirePart& part : chart.wire_parts) eases.push_back(part.ease);
  return eases;
}

CombinedCharts combine(const std::vector<const Chart*>& charts) {
  CombinedCharts combined;
  for (const Chart* const from : charts) {
    const Chart& chart = *from;
    const auto first_half_edge = static_cast<int>(combined.chart.mesh.n_halfedges());
    combined.first_vertex.push_back(static_cast<int>(combined.chart.mesh.n_vertices()));
    combined.first_edge.push_back(static_cast<int>(combined.chart.mesh.n_edges()));
    combined.first_part.push_back(static_cast<int>(combined.chart.wire_parts.size()));
    append_mesh(chart.mesh, combined.chart.mesh);
    combined.chart.source_vertex.insert(combined.chart.source_vertex.end(), chart.source_vertex.begin(),
                                        chart.source_vertex.end());
    std::vector<double> ratios = chart.length_ratio;
    ratios.resize(chart.mesh.n_edges(), 1);
    combined.chart.length_ratio.insert(combined.chart.length_ratio.end(), ratios.begin(), ratios.end());
    for (WirePart part : chart.wire_parts) {
      part.half_edges = moved(std::move(part.half_edges), first_half_edge);
      combined.chart.wire_parts.push_back(std::move(part));
    }
    for (const HalfEdgeChain& loop : chart.boundary_loops) {
      combined.chart.boundary_loops.push_back(moved(loop, first_half_edge));
    }
  }
  return combined;
}

}  // namespace wirewarp
