// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a path on a mesh a chain of edges, by splitting combinatorially: a crossed triangle becomes two or three
// (paper III-A, step 2, without a triangulator).
#pragma once

#include <optional>

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Moves crossings near a vertex to it, so that no sliver is cut off. The path passes each triangle at most once.
/// reach: part of an edge within which its ends are near, below 1/2.
MeshPath snap_to_vertices(const HalfEdgeMesh& mesh, const MeshPath& path, double reach);

/// The same within a tenth, and ends the path at the first wire vertex it reaches; at a wire edge that is the edge's
/// nearer end. Empty if the path then goes nowhere: it ends where no wire is, or all of it is a wire already.
std::optional<MeshPath> snap_to_wires(const HalfEdgeMesh& mesh, const WireMask& wires, const MeshPath& path);

/// Splits the edges a snapped path crosses, and returns the path as a chain of half-edges.
HalfEdgeChain embed_path(SplitChart& refined, const MeshPath& path);

}  // namespace wirewarp
