// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth lines for cuts: a path of edges becomes a line straight across the triangles.
#pragma once

#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Where a line passes a vertex or crosses an edge.
struct LinePoint {
  VertexPair edge;  // its ends; a vertex: that one twice
  double t = 0;     // at edge[0] + t (edge[1] - edge[0]), in (0, 1); a vertex: 0
};

/// The shortest line among the triangles that touch a path of edges inside the pieces of the input, with the same
/// ends: zigzags become straight, and what bends on purpose stays within a triangle of where it was. It meets seams,
/// outlines and wires at the same vertices as the path, and keeps a quarter of an edge away from their other vertices.
/// Where it would cross an edge nearer to an end than a twentieth of it, it passes through the end, so that cutting it
/// into the mesh leaves no slivers. Each triangle is crossed once at most by what lies between two vertices of the line
/// on wires, seams or outlines.
///
/// path: vertices, each joined to the next by an edge that is on no seam or outline. What it is to be a seam of later
/// must not be one yet. Throws what flatten() throws of the input; invalid_option, naming the pair, for a path that is
/// none; the error of a piece on its way whose faces are no surface.
std::vector<LinePoint> straighten_path(const FlattenInput& input, const std::vector<int>& path);

}  // namespace wirewarp
