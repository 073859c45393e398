// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a path on a mesh into a chain of edges by splitting: a crossed triangle becomes two or three (paper III-A, step
// 2, without a triangulator).
#pragma once

#include <optional>

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Moves crossings near a vertex to the vertex, so that no sliver is cut off. The path passes each triangle at most
/// once. reach: share of an edge within which a crossing snaps to an end, below 1/2.
MeshPath snap_to_vertices(const HalfEdgeMesh& mesh, const MeshPath& path, double reach);

/// Does the same with reach 0.1, and ends the path at the first wire vertex it reaches; from a wire edge it goes to the
/// edge's nearer end. Returns nothing if the path does not end on a wire, or if it is an edge of a wire already.
std::optional<MeshPath> snap_to_wires(const HalfEdgeMesh& mesh, const WireMask& wires, const MeshPath& path);

/// Splits the edges that a snapped path crosses, and returns the path as a chain of half-edges.
HalfEdgeChain embed_path(SplitChart& refined, const MeshPath& path);

}  // namespace wirewarp
