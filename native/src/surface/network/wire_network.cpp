// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/network/wire_network.h"

#include "base/disjoint_sets.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

void add_wire_edges(const Chart& chart, bool with_free_wires, WireNetwork& network) {
  const HalfEdgeMesh& mesh = chart.mesh;
  network.wire_edge_of_edge.assign(mesh.n_edges(), -1);
  const auto add = [&](HalfedgeHandle h, int part, bool is_boundary) {
    const EdgeHandle edge = mesh.edge_handle(h);
    network.wire_edge_of_edge[edge.idx()] = static_cast<int>(network.edges.size());
    const auto middle = (mesh.point(mesh.from_vertex_handle(h)) + mesh.point(mesh.to_vertex_handle(h))) / 2;
    network.edges.push_back(
        {edge, part, is_boundary, length_ratio(chart, h) * edge_length(mesh, h), {middle[0], middle[1], middle[2]}});
  };
  for (int part = 0; part < static_cast<int>(chart.wire_parts.size()); ++part) {
    const WireKind kind = chart.wire_parts[part].kind;
    if (kind == WireKind::boundary || (kind == WireKind::super_elastic && !with_free_wires)) continue;
    for (const HalfedgeHandle h : chart.wire_parts[part].half_edges) add(h, part, false);
  }
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) add(h, -1, true);
  }
  for (int part = 0; part < static_cast<int>(chart.wire_parts.size()); ++part) {
    if (!is_elastic_boundary(chart.wire_parts[part])) continue;
    for (const HalfedgeHandle h : chart.wire_parts[part].half_edges) {
      network.edges[network.wire_edge_of_edge[mesh.edge_handle(h).idx()]].part = part;
    }
  }
}

bool is_wire(const HalfEdgeMesh& mesh, const WireNetwork& network, HalfedgeHandle h) {
  return network.wire_edge_of_edge[mesh.edge_handle(h).idx()] >= 0;
}

/// Returns the node of the sector from `out` counter-clockwise to the next wire edge.
WireNode measure_node(const HalfEdgeMesh& mesh, const WireNetwork& network, HalfedgeHandle out) {
  WireNode node;
  node.vertex = mesh.from_vertex_handle(out);
  node.out = wire_half_edge(mesh, network, out);
  HalfedgeHandle h = out;
  do {
    node.surface_angle += corner_angle(mesh, h);
    h = next_counterclockwise(mesh, h);
  } while (!is_wire(mesh, network, h));
  node.in = wire_half_edge(mesh, network, mesh.opposite_halfedge_handle(h));
  node.length = (network.edges[node.in.edge].length + network.edges[node.out.edge].length) / 2;
  node.is_tail = node.in.edge == node.out.edge;
  return node;
}

void add_nodes(const HalfEdgeMesh& mesh, WireNetwork& network) {
  std::vector<std::vector<int>> nodes_of_vertex(mesh.n_vertices());
  for (const WireEdge& edge : network.edges) {
    for (unsigned side = 0; side < 2; ++side) {
      const HalfedgeHandle out = mesh.halfedge_handle(edge.edge, side);
      if (mesh.is_boundary(out)) continue;
      const VertexHandle v = mesh.from_vertex_handle(out);
      if (!mesh.is_boundary(v)) nodes_of_vertex[v.idx()].push_back(static_cast<int>(network.nodes.size()));
      network.nodes.push_back(measure_node(mesh, network, out));
    }
  }
  for (std::vector<int>& nodes : nodes_of_vertex) {
    if (!nodes.empty()) network.inner_vertex_nodes.push_back(std::move(nodes));
  }
}

/// Numbers the regions between wires, and returns the region of each face.
std::vector<int> find_patch_of_face(const HalfEdgeMesh& mesh, const WireNetwork& network, int& num_patches) {
  DisjointSets faces(mesh.n_faces());
  for (const EdgeHandle e : mesh.edges()) {
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    if (is_wire(mesh, network, h)) continue;
    faces.unite(mesh.face_handle(h).idx(), mesh.opposite_face_handle(h).idx());
  }
  return faces.number(num_patches);
}

void add_patches(const HalfEdgeMesh& mesh, WireNetwork& network) {
  int num_patches = 0;
  const std::vector<int> patch_of_face = find_patch_of_face(mesh, network, num_patches);
  network.patches.resize(num_patches);
  const std::vector<int> node_after = nodes_at_arrival(network);
  std::vector<char> is_seen(network.nodes.size(), 0);
  for (int start = 0; start < static_cast<int>(network.nodes.size()); ++start) {
    if (is_seen[start]) continue;
    std::vector<WirePatch::Step> loop;
    for (int node = start; !is_seen[node]; node = node_after[place_of(network.nodes[node].out)]) {
      is_seen[node] = 1;
      loop.push_back({node, network.nodes[node].out});
    }
    const WireHalfEdge first = loop[0].half_edge;
    const HalfedgeHandle h = mesh.halfedge_handle(network.edges[first.edge].edge, first.reversed ? 1 : 0);
    network.patches[patch_of_face[mesh.face_handle(h).idx()]].loops.push_back(std::move(loop));
  }
}

WireNetwork build_network(const Chart& chart, bool with_free_wires) {
  WireNetwork network;
  add_wire_edges(chart, with_free_wires, network);
  add_nodes(chart.mesh, network);
  add_patches(chart.mesh, network);
  for (std::size_t i = 1; i < chart.boundary_loops.size(); ++i) {
    const HalfEdgeChain& loop = chart.boundary_loops[i];
    std::vector<WireHalfEdge> hole;
    for (auto h = loop.rbegin(); h != loop.rend(); ++h) {
      hole.push_back(wire_half_edge(chart.mesh, network, chart.mesh.opposite_halfedge_handle(*h)));
    }
    network.holes.push_back(std::move(hole));
  }
  return network;
}

}  // namespace

std::vector<int> nodes_at_arrival(const WireNetwork& network) {
  std::vector<int> nodes(2 * network.edges.size(), -1);
  for (int i = 0; i < static_cast<int>(network.nodes.size()); ++i) nodes[place_of(network.nodes[i].in)] = i;
  return nodes;
}

WireNetwork build_wire_network(const Chart& chart) { return build_network(chart, true); }

HeldNetwork build_held_network(const Chart& chart) { return {build_network(chart, false)}; }

}  // namespace wirewarp
