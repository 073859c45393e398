// SPDX-License-Identifier: GPL-3.0-or-later
// The surface cut along its seams: which faces stay connected, and which corners remain one vertex.
#pragma once

#include <vector>

#include "surface/mesh/edge_table.h"

namespace wirewarp {

struct SurfaceCut {
  std::vector<char> is_seam;       // per edge: marked, and with at least two sides
  std::vector<int> chart_of_face;  // charts are numbered by their lowest face
  /// For each corner 3 f + k: the fan, which has the corners of one vertex that faces connect.
  std::vector<int> fan_of_corner;
  int num_charts = 0;
  int num_fans = 0;

  /// Whether the edge is on the outline of a chart: a seam, or the edge of the surface.
  bool is_outline(const EdgeTable& edges, int edge) const { return is_seam[edge] != 0 || edges.num_sides(edge) == 1; }
};

/// seams: vertex pairs; each must be an edge.
SurfaceCut cut_along_seams(const Triangles& faces, const EdgeTable& edges, const VertexPairs& seams);

/// Returns the fan of each corner, united across every shared edge including seams. Two fans at one vertex mean that
/// faces only touch there in a point.
std::vector<int> fans_of_uncut_surface(const Triangles& faces, const EdgeTable& edges);

}  // namespace wirewarp
