// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarsen/coarse_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

class Coarsening {
 public:
  Coarsening(const Chart& chart, const HeldNetwork& network, double edge_length, const StopToken& stop)
      : fine_(chart), fine_network_(network), decimated_(decimate(chart, network, edge_length, stop)) {}

  CoarseChart run();

 private:
  HalfedgeHandle fine_half_edge(WireHalfEdge h) const { return half_edge(fine_, fine_network_, h); }
  VertexHandle fine_start(WireHalfEdge h) const { return fine_.mesh.from_vertex_handle(fine_half_edge(h)); }
  VertexHandle coarse_vertex(VertexHandle v) const { return VertexHandle(decimated_.coarse_vertex[v.idx()]); }
  HalfEdgeChain coarse_chain(const HalfEdgeChain& chain, bool is_closed) const;
  void build_chart();
  void take_runs();
  void measure_nodes();
  void place_wire_vertices(const WireRun& run, int edge);

  const Chart& fine_;
  const HeldNetwork& fine_network_;
  DecimatedMesh decimated_;
  CoarseChart coarse_;
  std::vector<int> fine_nodes_;  // per half-edge of the fine network: node at which it arrives
};

HalfEdgeChain Coarsening::coarse_chain(const HalfEdgeChain& chain, bool is_closed) const {
  std::vector<VertexHandle> left;
  const auto add = [&](VertexHandle v) {
    if (v.is_valid()) left.push_back(v);
  };
  for (const HalfedgeHandle h : chain) add(coarse_vertex(fine_.mesh.from_vertex_handle(h)));
  add(is_closed ? left.front() : coarse_vertex(fine_.mesh.to_vertex_handle(chain.back())));
  HalfEdgeChain result;
  for (std::size_t i = 1; i < left.size(); ++i) {
    result.push_back(coarse_.chart.mesh.find_halfedge(left[i - 1], left[i]));
  }
  return result;
}

void Coarsening::build_chart() {
  coarse_.chart.mesh = std::move(decimated_.mesh);
  for (const int v : decimated_.fine_vertex) coarse_.chart.source_vertex.push_back(fine_.source_vertex[v]);
  // The coarse chart is not a part of an input, so its source faces are its own.
  coarse_.chart.source_face.resize(coarse_.chart.mesh.n_faces());
  std::iota(coarse_.chart.source_face.begin(), coarse_.chart.source_face.end(), 0);
  for (const WirePart& part : fine_.wire_parts) {
    if (!has_own_length(part)) continue;
    coarse_.chart.wire_parts.push_back(part);
    coarse_.chart.wire_parts.back().half_edges = coarse_chain(part.half_edges, false);
  }
  for (const HalfEdgeChain& loop : fine_.boundary_loops) {
    coarse_.chart.boundary_loops.push_back(coarse_chain(loop, true));
  }
  coarse_.network = build_held_network(coarse_.chart);
}

void Coarsening::take_runs() {
  std::vector<char> stays;
  for (const int v : decimated_.coarse_vertex) stays.push_back(v == -1 ? 0 : 1);
  coarse_.runs.resize(coarse_.network.edges.size());
  coarse_.wire_places.resize(fine_network_.edges.size());
  for (WireRun& run : find_wire_runs(fine_, fine_network_, stays)) {
    const HalfEdgeMesh& mesh = coarse_.chart.mesh;
    const HalfedgeHandle h = mesh.find_halfedge(coarse_vertex(fine_start(run.half_edges.front())),
                                                coarse_vertex(fine_start(opposite(run.half_edges.back()))));
    if (h != mesh.halfedge_handle(mesh.edge_handle(h), 0)) {
      std::reverse(run.half_edges.begin(), run.half_edges.end());
      for (WireHalfEdge& one : run.half_edges) one = opposite(one);
    }
    unroll(fine_network_, fine_nodes_, run);
    const int edge = coarse_.network.wire_edge_of_edge[mesh.edge_handle(h).idx()];
    coarse_.network.edges[edge].length = run.chord_length;
    place_wire_vertices(run, edge);
    coarse_.runs[edge] = std::move(run);
  }
}

void Coarsening::place_wire_vertices(const WireRun& run, int edge) {
  const HalfedgeHandle h = coarse_.chart.mesh.halfedge_handle(coarse_.network.edges[edge].edge, 0);
  const int begin = coarse_.chart.mesh.from_vertex_handle(h).idx(), end = coarse_.chart.mesh.to_vertex_handle(h).idx();
  double walked = 0;
  for (const WireHalfEdge one : run.half_edges) {
    const double from = walked / run.walked_length;
    if (walked > 0) decimated_.places[fine_start(one).idx()] = {{begin, end, end}, {1 - from, from, 0}};
    walked += fine_network_.edges[one.edge].length;
    const double to = walked / run.walked_length;
    coarse_.wire_places[one.edge] = {edge, one.reversed ? to : from, one.reversed ? from : to};
  }
}

/// Computes the surface angles between chords from the surface angles between the end edges of the runs.
void Coarsening::measure_nodes() {
  for (WireNode& node : coarse_.network.nodes) {
    const WireRun& in = coarse_.runs[node.in.edge];
    const WireRun& out = coarse_.runs[node.out.edge];
    const WireHalfEdge last = node.in.reversed ? opposite(in.half_edges.front()) : in.half_edges.back();
    const double turn_in = node.in.reversed ? in.headings.front() : in.headings.back();
    const double turn_out = node.out.reversed ? -out.headings.back() : -out.headings.front();
    const double one_sided = in.one_sided[node.in.reversed ? 0 : 1] + out.one_sided[node.out.reversed ? 1 : 0];
    const WireNode& fine = fine_network_.nodes[fine_nodes_[place_of(last)]];
    node.surface_angle = fine.surface_angle - turn_in - turn_out - one_sided;
    node.length = (in.chord_length + out.chord_length) / 2;
  }
}

CoarseChart Coarsening::run() {
  fine_nodes_ = nodes_at_arrival(fine_network_);
  build_chart();
  take_runs();
  measure_nodes();
  coarse_.places = std::move(decimated_.places);
  return std::move(coarse_);
}

}  // namespace

double typical_edge_length(const HalfEdgeMesh& mesh) {
  return std::sqrt(4 / std::sqrt(3.0) * surface_area(mesh) / static_cast<double>(mesh.n_faces()));
}

bool can_coarsen(const Chart& chart) {
  const HalfEdgeMesh& mesh = chart.mesh;
  return std::none_of(mesh.halfedges_begin(), mesh.halfedges_end(), [&](const HalfedgeHandle h) {
    return mesh.is_boundary(h) && mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) == h;
  });
}

CoarseChart coarsen(const Chart& chart, const HeldNetwork& network, double edge_length, const StopToken& stop) {
  return Coarsening(chart, network, edge_length, stop).run();
}

}  // namespace wirewarp
