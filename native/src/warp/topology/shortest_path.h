// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths that neither touch nor cross wires on their way (paper III-B, step 1): along edges first, its [44],
// then straightened to a geodesic.
#pragma once

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Multi-source Dijkstra along edges without wires, through vertices without wires, from any source to the nearest
/// target. Empty if none can be reached.
std::vector<VertexHandle> shortest_edge_path(const HalfEdgeMesh& mesh, const WireMask& wires,
                                             const std::vector<VertexHandle>& sources,
                                             const std::vector<char>& is_target);

/// The locally shortest path between the same ends: the shortest in the strip of triangles beside the path, and over
/// the other side of a vertex wherever that is shorter still. It keeps a quarter of an edge away from wires.
MeshPath straighten(const HalfEdgeMesh& mesh, const WireMask& wires, const std::vector<VertexHandle>& edge_path);

/// The same, but the shortest among the triangles that touch the path.
MeshPath straighten_nearby(const HalfEdgeMesh& mesh, const WireMask& wires, const std::vector<VertexHandle>& edge_path);

/// Adds a helper wire along the straightened shortest path from any source to the nearest target, and returns it.
/// Cuts edges for it where wires leave no room. Throws UnjoinedWires if no target lies in a region of a source, or
/// the straightened path ends elsewhere.
HalfEdgeChain join_by_shortest_path(SplitChart& refined, const std::vector<VertexHandle>& sources,
                                    std::vector<char> is_target);

}  // namespace wirewarp
