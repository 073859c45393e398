// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths along the edges of a chart.
#pragma once

#include <functional>
#include <vector>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// A forest of shortest paths, rooted at its sources.
struct ShortestPaths {
  std::vector<double> distance;         // per vertex, scene units; infinite if no path reaches it
  std::vector<HalfedgeHandle> arrival;  // per vertex: last half-edge of its path; invalid at a source
  VertexHandle end;                     // vertex at which the search ended; invalid if it reached all vertices
};

/// Restricts the region of the paths. A missing function restricts nothing.
struct PathRules {
  std::function<bool(HalfedgeHandle)> may_follow;
  /// The search stops at the nearest vertex for which this returns true. Vertices that are farther away may have no
  /// path, or a path that is not the shortest.
  std::function<bool(VertexHandle)> ends_at;
};

/// Returns the shortest path from the nearest source to each vertex (multi-source Dijkstra). sources: at least one.
ShortestPaths shortest_paths(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& sources,
                             const PathRules& rules = {});

/// Returns the half-edges from a source to a vertex, the last half-edge first.
std::vector<HalfedgeHandle> path_back(const HalfEdgeMesh& mesh, const ShortestPaths& paths, VertexHandle v);

/// Returns the vertex with the longest path, or the first of several vertices with equally long paths. Vertices without
/// a path are ignored.
VertexHandle farthest_vertex(const ShortestPaths& paths);

std::vector<VertexHandle> boundary_vertices(const HalfEdgeMesh& mesh);

}  // namespace wirewarp
