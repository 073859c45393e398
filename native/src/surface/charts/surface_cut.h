// SPDX-License-Identifier: GPL-3.0-or-later
// The surface cut open along its seams: which faces stay together, and which corners stay one vertex.
#pragma once

#include <vector>

#include "surface/mesh/edge_table.h"

namespace wirewarp {

struct SurfaceCut {
  std::vector<char> is_seam;       // per edge: marked, and with two sides or more
  std::vector<int> chart_of_face;  // charts numbered by their lowest face
  std::vector<int> fan_of_corner;  // corner 3 f + k -> fan: the corners of one vertex that faces connect
  int num_charts = 0;
  int num_fans = 0;

  /// Returns whether the edge is on the outline of a chart: a seam, or the edge of the surface.
  bool is_outline(const EdgeTable& edges, int edge) const { return is_seam[edge] != 0 || edges.num_sides(edge) == 1; }
};

/// seams: vertex pairs, each an edge.
SurfaceCut cut_along_seams(const Triangles& faces, const EdgeTable& edges, const VertexPairs& seams);

/// Corners joined across every shared edge, seams too: two fans at one vertex mean that faces touch there in nothing
/// but a point. Returns the fan of each corner.
std::vector<int> fans_of_uncut_surface(const Triangles& faces, const EdgeTable& edges);

}  // namespace wirewarp
