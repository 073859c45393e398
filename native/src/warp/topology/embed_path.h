// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a path on a mesh into a chain of edges by splitting: a crossed triangle becomes two or three (paper III-A, step
// 2, but without a constrained triangulation).
#pragma once

#include <optional>

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Moves crossings near a vertex to the vertex, so that the path cuts off no sliver. The path must pass each triangle
/// at most once. reach: share of an edge within which a crossing snaps to an end, below 1/2.
MeshPath snap_to_vertices(const HalfEdgeMesh& mesh, const MeshPath& path, double reach);

/// Snaps a path with reach 0.1, and ends it at the first wire vertex that it reaches. If the path reaches a wire edge,
/// it ends at the nearer end of that edge. Returns nullopt if the path does not end on a wire, or if the path is
/// already an edge of a wire.
std::optional<MeshPath> snap_to_wires(const HalfEdgeMesh& mesh, const WireMask& wires, const MeshPath& path);

/// Splits the edges that a snapped path crosses, and returns the path as a chain of half-edges.
HalfEdgeChain embed_path(SplitChart& split, const MeshPath& path);

}  // namespace wirewarp
