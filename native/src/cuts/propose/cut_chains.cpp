// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/cut_chains.h"

namespace wirewarp {
namespace {

/// Returns the half-edges from a vertex along the edges of the mask `left`.
HalfEdgeChain left_at(const HalfEdgeMesh& mesh, const CutMask& left, VertexHandle v) {
  HalfEdgeChain leaving;
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    if (left[mesh.edge_handle(h).idx()] != 0) leaving.push_back(h);
  }
  return leaving;
}

}  // namespace

std::vector<HalfEdgeChain> sections_of(const HalfEdgeMesh& mesh, const CutMask& cut) {
  CutMask left = cut;
  std::vector<HalfEdgeChain> sections;
  const auto is_junction = [&](VertexHandle v) { return left_at(mesh, cut, v).size() != 2; };
  const auto follow = [&](HalfedgeHandle h) {
    HalfEdgeChain& section = sections.emplace_back();
    while (true) {
      left[mesh.edge_handle(h).idx()] = 0;
      section.push_back(h);
      const VertexHandle end = mesh.to_vertex_handle(h);
      const HalfEdgeChain next = left_at(mesh, left, end);
      if (next.empty() || is_junction(end)) return;
      h = next.front();
    }
  };
  for (const bool rings : {false, true}) {
    for (const VertexHandle v : mesh.vertices()) {
      if (!rings && !is_junction(v)) continue;
      for (const HalfedgeHandle h : left_at(mesh, left, v)) {
        if (left[mesh.edge_handle(h).idx()] != 0) follow(h);
      }
    }
  }
  return sections;
}

std::vector<VertexPair> edges_by_section(const Chart& chart, const CutMask& cut) {
  std::vector<VertexPair> edges;
  for (const HalfEdgeChain& section : sections_of(chart.mesh, cut)) {
    for (const HalfedgeHandle h : section) edges.push_back(source_ends(chart, h));
  }
  return edges;
}

}  // namespace wirewarp
