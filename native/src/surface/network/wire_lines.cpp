// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/network/wire_lines.h"

namespace wirewarp {
namespace {

/// Returns for each half-edge of the network the next half-edge on its line; edge -1 if the line ends there.
std::vector<WireHalfEdge> follow_lines(const Chart& chart, const WireNetwork& network) {
  const HalfEdgeMesh& mesh = chart.mesh;
  std::vector<WireHalfEdge> onward(2 * network.edges.size());
  const auto join = [&](WireHalfEdge in, WireHalfEdge out) {
    onward[place_of(in)] = out;
    onward[place_of(opposite(out))] = opposite(in);
  };
  const auto join_chain = [&](const HalfEdgeChain& chain, bool is_closed) {
    for (std::size_t i = is_closed ? 0 : 1; i < chain.size(); ++i) {
      join(wire_half_edge(mesh, network, chain[i > 0 ? i - 1 : chain.size() - 1]),
           wire_half_edge(mesh, network, chain[i]));
    }
  };
  for (const WirePart& part : chart.wire_parts) {
    if (wire_half_edge(mesh, network, part.half_edges[0]).edge < 0) continue;  // not in the network
    const VertexHandle begin = mesh.from_vertex_handle(part.half_edges.front());
    join_chain(part.half_edges, begin == mesh.to_vertex_handle(part.half_edges.back()) && !mesh.is_boundary(begin));
  }
  for (const HalfEdgeChain& loop : chart.boundary_loops) join_chain(loop, true);
  for (const std::vector<int>& nodes : network.inner_vertex_nodes) {
    if (nodes.size() == 2) join(network.nodes[nodes[0]].in, network.nodes[nodes[0]].out);
  }
  return onward;
}

}  // namespace

WireLines find_lines(const Chart& chart, const WireNetwork& network) {
  const std::vector<WireHalfEdge> onward = follow_lines(chart, network);
  const std::vector<int> node_at_arrival = nodes_at_arrival(network);
  WireLines lines;
  for (const WireNode& node : network.nodes) {
    const WireHalfEdge out = onward[place_of(node.in)];
    if (!node.is_tail && node.out != out) lines.corners.push_back(node);
    if (out.edge < 0) continue;
    LineBend bend{node};
    while (bend.node.out != out) {  // clockwise, sector by sector
      const int next = node_at_arrival[place_of(opposite(bend.node.out))];
      if (next < 0) break;  // the surface ends on this side of the line
      bend.node.surface_angle += network.nodes[next].surface_angle;
      bend.node.out = network.nodes[next].out;
      bend.node.length += network.nodes[next].length;
      ++bend.num_sectors;
    }
    if (bend.node.out != out) continue;
    bend.node.length /= bend.num_sectors;
    lines.bends.push_back(bend);
  }
  return lines;
}

}  // namespace wirewarp
