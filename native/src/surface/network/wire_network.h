// SPDX-License-Identifier: GPL-3.0-or-later
// The wire network of a chart: all wires and boundaries, the wire-patches between them and the wire-nodes at their
// corners (paper II-A, Fig. 2).
//
//   Υ          WireNetwork
//   P_p        patches[p], the loop of its boundary walked with the patch on the left
//   q_i        nodes[i], one corner of one wire-patch
//   Γ_p(b)     patches[p].loops[..][b].node
//   α_i        nodes[i].surface_angle
//   l⁰         edges[e].length, at h = ease
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// A chart edge on a wire or on the boundary.
struct WireEdge {
  EdgeHandle edge;
  int part = -1;  // index into Chart::wire_parts, -1: boundary of fixed length
  bool is_boundary = false;
  double length = 0;                                 // in 3D, times what eases ask for; scene units
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // 3D, where it lies on the surface
};

/// A wire edge walked in one direction.
struct WireHalfEdge {
  int edge = -1;          // index into WireNetwork::edges
  bool reversed = false;  // true: against halfedge_handle(edge, 0)

  bool operator==(const WireHalfEdge& other) const { return edge == other.edge && reversed == other.reversed; }
  bool operator!=(const WireHalfEdge& other) const { return !(*this == other); }
};

/// One corner of one wire-patch: the sector between two consecutive wire edges around a vertex, the patch inside.
struct WireNode {
  VertexHandle vertex;
  WireHalfEdge in;           // arrives at the vertex, the patch on its left
  WireHalfEdge out;          // leaves it, the patch on its left
  double surface_angle = 0;  // α, radians
  double length = 0;         // ℓ, mean length of its two edges
  bool is_tail = false;      // in and out are the same edge: the vertex has no other wire edge
};

struct WirePatch {
  struct Step {
    int node;  // where the half-edge starts
    WireHalfEdge half_edge;
  };
  std::vector<std::vector<Step>> loops;  // counter-clockwise; one for a disk, more when wires or holes float in it
};

struct WireNetwork {
  std::vector<WireEdge> edges;
  std::vector<WireNode> nodes;
  std::vector<WirePatch> patches;
  std::vector<std::vector<WireHalfEdge>> holes;      // inner boundary loops, the hole on the left
  std::vector<int> wire_edge_of_edge;                // chart edge index -> index into edges, -1 none
  std::vector<std::vector<int>> inner_vertex_nodes;  // nodes around each network vertex inside the chart
};

inline WireHalfEdge opposite(WireHalfEdge h) { return {h.edge, !h.reversed}; }

/// Half-edges of a network in a row: two an edge.
inline std::size_t place_of(WireHalfEdge h) { return 2 * h.edge + (h.reversed ? 1 : 0); }

inline HalfedgeHandle half_edge(const Chart& chart, const WireNetwork& network, WireHalfEdge h) {
  return chart.mesh.halfedge_handle(network.edges[h.edge].edge, h.reversed ? 1 : 0);
}

/// Returns edge -1 if h is not in the network.
inline WireHalfEdge wire_half_edge(const HalfEdgeMesh& mesh, const WireNetwork& network, HalfedgeHandle h) {
  const EdgeHandle edge = mesh.edge_handle(h);
  return {network.wire_edge_of_edge[edge.idx()], h != mesh.halfedge_handle(edge, 0)};
}

/// For each half-edge of a network the node where it arrives, -1: a boundary walked with the chart on the right.
std::vector<int> nodes_at_arrival(const WireNetwork& network);

/// All wires and boundaries of a chart and how they meet. Any network: nothing is refused here.
WireNetwork build_wire_network(const Chart& chart);

/// Without super-elastic wires: the network of all edges whose length is held.
struct HeldNetwork : WireNetwork {};

HeldNetwork build_held_network(const Chart& chart);

}  // namespace wirewarp
