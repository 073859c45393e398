// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/slit_to_far_end.h"

#include "mesh/shortest_paths.h"

namespace wirewarp {
namespace {

/// Where slits may begin: all of the boundary, or a far end of a closed surface.
std::vector<VertexHandle> starts(const HalfEdgeMesh& mesh) {
  std::vector<VertexHandle> boundary;
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_boundary(v)) boundary.push_back(v);
  }
  if (!boundary.empty()) return boundary;
  return {farthest_vertex(shortest_paths(mesh, {VertexHandle(0)}))};
}

}  // namespace

CutMask slit_to_far_end(const HalfEdgeMesh& mesh) {
  const std::vector<VertexHandle> sources = starts(mesh);
  const ShortestPaths paths = shortest_paths(mesh, sources);
  const std::vector<HalfedgeHandle> path = path_back(mesh, paths, farthest_vertex(paths));
  CutMask cut(mesh.n_edges(), 0);
  // Both sides of a single edge inside a closed surface would be one loop of two edges between the same vertices.
  if (path.size() == 1 && !mesh.is_boundary(sources.front())) return cut;
  for (const HalfedgeHandle h : path) cut[mesh.edge_handle(h).idx()] = 1;
  return cut;
}

}  // namespace wirewarp
