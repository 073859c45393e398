// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths that neither touch nor cross wires on their way (paper III-B, step 1): first along edges (the paper's
// reference [44]), then straightened to a geodesic.
#pragma once

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Returns the shortest path by multi-source Dijkstra along edges and through vertices without wires, from any source
/// to the nearest target. Returns an empty path if no target can be reached.
std::vector<VertexHandle> shortest_edge_path(const HalfEdgeMesh& mesh, const WireMask& wires,
                                             const std::vector<VertexHandle>& sources,
                                             const std::vector<char>& is_target);

/// Returns a locally shortest path between the ends of edge_path. The path stays a quarter of an edge away from wires.
MeshPath straighten(const HalfEdgeMesh& mesh, const WireMask& wires, const std::vector<VertexHandle>& edge_path);

/// Returns a locally shortest path between the ends of edge_path, within the triangles that touch edge_path.
MeshPath straighten_nearby(const HalfEdgeMesh& mesh, const WireMask& wires, const std::vector<VertexHandle>& edge_path);

/// Adds and returns a helper wire along the straightened shortest path from any source to the nearest target. Splits
/// edges if wires leave no room. Throws UnjoinedWires if no path is found.
HalfEdgeChain join_by_shortest_path(SplitChart& split, const std::vector<VertexHandle>& sources,
                                    std::vector<char> is_target);

}  // namespace wirewarp
