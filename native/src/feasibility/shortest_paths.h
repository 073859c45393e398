// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths along edges to every vertex of a chart. Wires do not bar them: a seam may run along a wire.
#pragma once

#include <vector>

#include "mesh/half_edge_mesh.h"

namespace wirewarp {

/// A forest of shortest paths, rooted at its sources.
struct ShortestPaths {
  std::vector<double> distance;         // per vertex, scene units
  std::vector<HalfedgeHandle> arrival;  // per vertex: the last half-edge of its path; not valid at a source
};

/// sources: at least one; the mesh is connected.
ShortestPaths shortest_paths(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& sources);

/// The half-edges from a source to a vertex, the last one first.
std::vector<HalfedgeHandle> path_back(const HalfEdgeMesh& mesh, const ShortestPaths& paths, VertexHandle v);

VertexHandle farthest_vertex(const ShortestPaths& paths);

}  // namespace wirewarp
