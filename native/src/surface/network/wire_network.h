// SPDX-License-Identifier: GPL-3.0-or-later
// The wire network of a chart: all wires and boundaries, the wire-patches between them and the wire-nodes at their
// corners (paper II-A, Fig. 2).
//
//   Υ          WireNetwork
//   P_p        patches[p]; its boundary is a loop with the patch on the left
//   q_i        nodes[i], one corner of one wire-patch
//   Γ_p(b)     patches[p].loops[..][b].node
//   α_i        nodes[i].surface_angle
//   l⁰         edges[e].length, the target length at h = ease
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// A chart edge on a wire or on the boundary.
struct WireEdge {
  EdgeHandle edge;
  int part = -1;  // index into Chart::wire_parts; -1: boundary of fixed length
  bool is_boundary = false;
  double length = 0;                                 // target length at h = ease, scene units
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // midpoint on the surface, 3D
};

/// A wire edge walked in one direction.
struct WireHalfEdge {
  int edge = -1;          // index into WireNetwork::edges
  bool reversed = false;  // true: against halfedge_handle(edge, 0)

  bool operator==(const WireHalfEdge& other) const { return edge == other.edge && reversed == other.reversed; }
  bool operator!=(const WireHalfEdge& other) const { return !(*this == other); }
};

/// One corner of one wire-patch: the sector inside the patch between two consecutive wire edges around a vertex.
struct WireNode {
  VertexHandle vertex;
  WireHalfEdge in;           // arrives at the vertex; the patch is on its left
  WireHalfEdge out;          // leaves the vertex; the patch is on its left
  double surface_angle = 0;  // α, radians
  double length = 0;         // ℓ, mean length of the edges `in` and `out`
  bool is_tail = false;      // in and out are the same edge: the vertex has no other wire edge
};

struct WirePatch {
  struct Step {
    int node;  // node at the start of the half-edge
    WireHalfEdge half_edge;
  };
  /// Counter-clockwise loops: one for a disk, more if separate wires or holes are inside.
  std::vector<std::vector<Step>> loops;
};

struct WireNetwork {
  std::vector<WireEdge> edges;
  std::vector<WireNode> nodes;
  std::vector<WirePatch> patches;
  std::vector<std::vector<WireHalfEdge>> holes;      // inner boundary loops; the hole is on the left
  std::vector<int> wire_edge_of_edge;                // chart edge index -> index into edges; -1: none
  std::vector<std::vector<int>> inner_vertex_nodes;  // nodes around each network vertex inside the chart
};

inline WireHalfEdge opposite(WireHalfEdge h) { return {h.edge, !h.reversed}; }

/// Returns the index of a half-edge in a list of all half-edges of a network, two per edge.
inline std::size_t place_of(WireHalfEdge h) { return 2 * h.edge + (h.reversed ? 1 : 0); }

inline HalfedgeHandle half_edge(const Chart& chart, const WireNetwork& network, WireHalfEdge h) {
  return chart.mesh.halfedge_handle(network.edges[h.edge].edge, h.reversed ? 1 : 0);
}

/// Returns the half-edge of the network at h; edge -1 if h is not in the network.
inline WireHalfEdge wire_half_edge(const HalfEdgeMesh& mesh, const WireNetwork& network, HalfedgeHandle h) {
  const EdgeHandle edge = mesh.edge_handle(h);
  return {network.wire_edge_of_edge[edge.idx()], h != mesh.halfedge_handle(edge, 0)};
}

/// Returns for each half-edge of a network the node where it arrives; -1 for a half-edge of the boundary with the chart
/// on its right.
std::vector<int> nodes_at_arrival(const WireNetwork& network);

/// Returns all wires and boundaries of a chart with their corners and patches. Accepts any arrangement of wires.
WireNetwork build_wire_network(const Chart& chart);

/// The network without super-elastic wires: all edges with a fixed or elastic length.
struct HeldNetwork : WireNetwork {};

HeldNetwork build_held_network(const Chart& chart);

}  // namespace wirewarp
