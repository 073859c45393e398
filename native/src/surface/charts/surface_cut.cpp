// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/surface_cut.h"

#include "base/disjoint_sets.h"

namespace wirewarp {
namespace {

/// Unites the corners at each end of an edge, over all faces of the edge.
void join_corners(const EdgeTable& edges, int edge, DisjointSets& corners) {
  for (int j = 1; j < edges.num_sides(edge); ++j) {
    for (int vertex : edges.vertices(edge)) {
      corners.unite(edges.corner_at(edges.side(edge, 0), vertex), edges.corner_at(edges.side(edge, j), vertex));
    }
  }
}

}  // namespace

SurfaceCut cut_along_seams(const Triangles& faces, const EdgeTable& edges, const VertexPairs& seams) {
  SurfaceCut cut;
  cut.is_seam.assign(edges.num_edges(), 0);
  for (int i = 0; i < seams.rows(); ++i) {
    const int edge = edges.find(seams(i, 0), seams(i, 1));
    if (edges.num_sides(edge) > 1) cut.is_seam[edge] = 1;
  }
  const auto num_faces = static_cast<std::size_t>(faces.rows());
  DisjointSets charts(num_faces);
  DisjointSets corners(3 * num_faces);
  for (int e = 0; e < edges.num_edges(); ++e) {
    if (cut.is_seam[e]) continue;
    join_corners(edges, e, corners);
    for (int j = 1; j < edges.num_sides(e); ++j) charts.unite(edges.side(e, 0) / 3, edges.side(e, j) / 3);
  }
  cut.chart_of_face = charts.number(cut.num_charts);
  cut.fan_of_corner = corners.number(cut.num_fans);
  return cut;
}

std::vector<int> fans_of_uncut_surface(const Triangles& faces, const EdgeTable& edges) {
  DisjointSets corners(3 * static_cast<std::size_t>(faces.rows()));
  for (int e = 0; e < edges.num_edges(); ++e) join_corners(edges, e, corners);
  int count = 0;
  return corners.number(count);
}

}  // namespace wirewarp
