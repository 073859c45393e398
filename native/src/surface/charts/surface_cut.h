// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the surface along its seams: finds the faces that stay connected, and the corners that stay one vertex.
#pragma once

#include <vector>

#include "surface/mesh/edge_table.h"

namespace wirewarp {

struct SurfaceCut {
  std::vector<char> is_seam;       // per edge: marked as a seam, and with at least two sides
  std::vector<int> chart_of_face;  // per face: index of its chart; charts are in the order of their first faces
  /// For each corner 3 f + k of a face f: its fan. The corners of a fan are at one vertex, and edges without a seam
  /// connect them.
  std::vector<int> fan_of_corner;
  int num_charts = 0;
  int num_fans = 0;

  /// Returns whether the edge is on the outline of a chart: on a seam, or on the border of the surface.
  bool is_outline(const EdgeTable& edges, int edge) const { return is_seam[edge] != 0 || edges.num_sides(edge) == 1; }
};

/// seams: vertex pairs, each of which must be an edge.
SurfaceCut cut_along_seams(const Triangles& faces, const EdgeTable& edges, const VertexPairs& seams);

/// Returns the fan of each corner on the uncut surface, on which seam edges connect corners, too. At a vertex with two
/// fans, the surface touches itself.
std::vector<int> fans_of_uncut_surface(const Triangles& faces, const EdgeTable& edges);

}  // namespace wirewarp
