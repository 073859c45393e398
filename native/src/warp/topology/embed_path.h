// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a path on a mesh into a chain of edges by splitting: a crossed triangle becomes two or three (paper III-A, step
// 2, but without a constrained triangulation).
#pragma once

#include <optional>

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Moves crossings near a vertex to the vertex, to avoid slivers. The path must pass each triangle at most once. reach:
/// share of an edge within which a crossing snaps to an end, below 1/2.
MeshPath snap_to_vertices(const HalfEdgeMesh& mesh, const MeshPath& path, double reach);

/// Snaps a path, and ends it at a vertex of the first wire that it reaches. Returns nullopt if it does not reach a
/// wire, or is an edge of a wire.
std::optional<MeshPath> snap_to_wires(const HalfEdgeMesh& mesh, const WireMask& wires, const MeshPath& path);

/// Splits the edges that a snapped path crosses, and returns the path as a chain of half-edges.
HalfEdgeChain embed_path(SplitChart& split, const MeshPath& path);

}  // namespace wirewarp
