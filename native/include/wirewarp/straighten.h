// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth lines for cuts. straighten_path() replaces a path of edges with a straight line across the triangles.
#pragma once

#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// A point of a line, at a vertex or on an edge.
struct LinePoint {
  VertexPair edge;  // ends of the edge; for a vertex, its index twice
  double t = 0;     // position edge[0] + t (edge[1] - edge[0]), in (0, 1); 0 for a vertex
};

/// Returns the shortest line through the triangles that touch a path of edges, with the same ends.
///
/// - Zigzags become straight, and intended bends move by at most one triangle.
/// - The line meets seams, outlines and wires at the same vertices as the path. It stays a quarter of an edge away from
///   their other vertices.
/// - Instead of crossing an edge within a twentieth of its length from an end, the line passes through this end.
///   Therefore, cutting the line into the mesh leaves no slivers.
/// - Between two vertices on wires, seams or outlines, the line crosses each triangle at most once.
///
/// path: different vertices, each joined to the next by an edge that is not on a seam or outline. Edges of a future
/// seam must not be marked as seams yet.
///
/// Throws:
///
/// - the errors of flatten() for the input
/// - invalid_option if path passes a vertex twice or does not follow mesh edges
/// - the error of a piece if its faces along the path are not a surface
std::vector<LinePoint> straighten_path(const FlattenInput& input, const std::vector<int>& path);

}  // namespace wirewarp
