// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/outline.h"

#include <algorithm>

namespace wirewarp {
namespace {

/// Returns the fans at one end of an edge, one per side, sorted.
std::vector<int> fans_at(const EdgeTable& edges, const SurfaceCut& cut, int edge, int vertex) {
  std::vector<int> fans;
  for (int j = 0; j < edges.num_sides(edge); ++j) {
    fans.push_back(cut.fan_of_corner[edges.corner_at(edges.side(edge, j), vertex)]);
  }
  std::sort(fans.begin(), fans.end());
  return fans;
}

/// The outline edges at each vertex. A chain continues through a vertex with two outline edges if both edges have the
/// same fans on their sides.
struct OutlineVertices {
  std::vector<int> degree;
  std::vector<std::array<int, 2>> edges;  // the first two outline edges of each vertex
};

OutlineVertices find_outline_vertices(const EdgeTable& edges, const SurfaceCut& cut, std::size_t num_vertices) {
  OutlineVertices outline{std::vector<int>(num_vertices, 0), std::vector<std::array<int, 2>>(num_vertices)};
  for (int e = 0; e < edges.num_edges(); ++e) {
    if (!cut.is_outline(edges, e)) continue;
    for (int v : edges.vertices(e)) {
      if (outline.degree[v] < 2) outline.edges[v][outline.degree[v]] = e;
      ++outline.degree[v];
    }
  }
  return outline;
}

/// Follows a chain from one end of an edge until it ends or closes.
std::vector<VertexPair> trace_chain(const EdgeTable& edges, const OutlineVertices& vertices, int edge, int from,
                                    Outline& outline) {
  std::vector<VertexPair> chain;
  const int index = static_cast<int>(outline.chains.size());
  while (outline.chain_of_edge[edge] < 0) {
    outline.chain_of_edge[edge] = index;
    const VertexPair& ends = edges.vertices(edge);
    const int to = ends[0] == from ? ends[1] : ends[0];
    chain.push_back({from, to});
    if (outline.is_junction[to]) break;
    const std::array<int, 2>& pair = vertices.edges[to];
    edge = pair[0] == edge ? pair[1] : pair[0];
    from = to;
  }
  return chain;
}

}  // namespace

Outline trace_outline(const Triangles& faces, const EdgeTable& edges, const SurfaceCut& cut) {
  const std::size_t num_vertices = faces.size() == 0 ? 0 : faces.maxCoeff() + 1;
  const OutlineVertices vertices = find_outline_vertices(edges, cut, num_vertices);
  Outline outline;
  outline.is_on_outline.resize(num_vertices);
  outline.is_junction.resize(num_vertices);
  outline.chain_of_edge.assign(edges.num_edges(), -1);
  for (int v = 0; v < static_cast<int>(num_vertices); ++v) {
    const int degree = vertices.degree[v];
    outline.is_on_outline[v] = degree > 0;
    if (degree == 0) continue;
    const std::array<int, 2>& pair = vertices.edges[v];
    outline.is_junction[v] = degree != 2 || fans_at(edges, cut, pair[0], v) != fans_at(edges, cut, pair[1], v);
  }

  int num_seams = 0;
  const auto add_chain = [&](int edge, int from) {
    std::vector<VertexPair> chain = trace_chain(edges, vertices, edge, from, outline);
    outline.chains.push_back(std::move(chain));
    outline.seam_of_chain.push_back(cut.is_seam[edge] ? num_seams++ : -1);
  };
  // Chains that end at junctions come first, then chains without a junction, which are closed.
  for (int e = 0; e < edges.num_edges(); ++e) {
    if (!cut.is_outline(edges, e)) continue;
    for (int v : edges.vertices(e)) {
      if (outline.is_junction[v] && outline.chain_of_edge[e] < 0) add_chain(e, v);
    }
  }
  for (int e = 0; e < edges.num_edges(); ++e) {
    if (cut.is_outline(edges, e) && outline.chain_of_edge[e] < 0) add_chain(e, edges.vertices(e)[0]);
  }
  return outline;
}

std::vector<Seam> assign_boundary_chains(const EdgeTable& edges, const SurfaceCut& cut, const Outline& outline,
                                         std::vector<Chart>& charts) {
  std::vector<Seam> seams;
  for (std::size_t c = 0; c < outline.chains.size(); ++c) {
    if (outline.seam_of_chain[c] < 0) continue;
    seams.push_back({outline.chains[c], {}});
    const VertexPair& first = outline.chains[c][0];
    const int edge = edges.find(first[0], first[1]);
    for (int j = 0; j < edges.num_sides(edge); ++j) {
      const int chart = cut.chart_of_face[edges.side(edge, j) / 3];
      if (charts[chart].error) seams.back().sides.push_back({chart, -1});
    }
  }

  for (int c = 0; c < static_cast<int>(charts.size()); ++c) {
    Chart& chart = charts[c];
    if (chart.error) continue;
    const auto source = [&](VertexHandle v) { return chart.source_vertex[v.idx()]; };
    const auto chain_of = [&](HalfedgeHandle h) {
      return outline
          .chain_of_edge[edges.find(source(chart.mesh.from_vertex_handle(h)), source(chart.mesh.to_vertex_handle(h)))];
    };
    for (HalfEdgeChain loop : chart.boundary_loops) {
      const auto starts_chain = [&](HalfedgeHandle h) {
        return outline.is_junction[source(chart.mesh.from_vertex_handle(h))] != 0;
      };
      const auto first = std::find_if(loop.begin(), loop.end(), starts_chain);
      if (first != loop.end()) std::rotate(loop.begin(), first, loop.end());
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (i == 0 || starts_chain(loop[i])) {
          const int seam = outline.seam_of_chain[chain_of(loop[i])];
          if (seam >= 0) seams[seam].sides.push_back({c, static_cast<int>(chart.boundary_chains.size())});
          chart.boundary_chains.push_back({{}, seam});
        }
        chart.boundary_chains.back().half_edges.push_back(loop[i]);
      }
    }
  }
  for (Seam& seam : seams) {
    std::stable_sort(seam.sides.begin(), seam.sides.end(),
                     [](const Seam::Side& a, const Seam::Side& b) { return a.chart < b.chart; });
  }
  return seams;
}

}  // namespace wirewarp
