// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/connected_parts.h"

#include "base/disjoint_sets.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {

std::vector<ConnectedPart> find_connected_parts(const HalfEdgeMesh& mesh) {
  DisjointSets sets(mesh.n_vertices());
  for (const EdgeHandle e : mesh.edges()) {
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    sets.unite(mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx());
  }
  int count = 0;
  const std::vector<int> part_of_vertex = sets.number(count);
  std::vector<ConnectedPart> parts(static_cast<std::size_t>(count));
  for (std::size_t v = 0; v < part_of_vertex.size(); ++v) {
    parts[part_of_vertex[v]].vertices.push_back(static_cast<int>(v));
  }
  for (const FaceHandle f : mesh.faces()) {
    const VertexHandle v = mesh.from_vertex_handle(mesh.halfedge_handle(f));
    parts[part_of_vertex[v.idx()]].area += face_area(mesh, f);
  }
  return parts;
}

std::vector<double> area_at_vertices(const HalfEdgeMesh& mesh) {
  std::vector<double> area(mesh.n_vertices());
  for (const ConnectedPart& part : find_connected_parts(mesh)) {
    for (const int v : part.vertices) area[v] = part.area;
  }
  return area;
}

}  // namespace wirewarp
