// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths along the edges of a chart.
#pragma once

#include <functional>
#include <vector>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// A forest of shortest paths, rooted at its sources.
struct ShortestPaths {
  std::vector<double> distance;         // per vertex, scene units; infinite where no path leads
  std::vector<HalfedgeHandle> arrival;  // per vertex: the last half-edge of its path; not valid at a source
  VertexHandle end;                     // where the search ended; not valid if it reached all vertices
};

/// The region of the paths; a missing part restricts nothing.
struct PathRules {
  std::function<bool(HalfedgeHandle)> may_follow;
  std::function<bool(VertexHandle)> ends_at;  // the search stops at the nearest such vertex; farther paths are not done
};

/// Multi-source Dijkstra. sources: at least one.
ShortestPaths shortest_paths(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& sources,
                             const PathRules& rules = {});

/// Returns the half-edges from a source to a vertex, the last one first.
std::vector<HalfedgeHandle> path_back(const HalfEdgeMesh& mesh, const ShortestPaths& paths, VertexHandle v);

/// Returns one of the vertices that paths reach; the first of several.
VertexHandle farthest_vertex(const ShortestPaths& paths);

std::vector<VertexHandle> boundary_vertices(const HalfEdgeMesh& mesh);

}  // namespace wirewarp
