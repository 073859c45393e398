// SPDX-License-Identifier: GPL-3.0-or-later
// A strip of triangles between two vertices and the shortest path inside it.
#pragma once

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// A chain of adjacent triangles without repetition, from a triangle at `start` to a triangle at `end`.
struct Strip {
  VertexHandle start;
  VertexHandle end;
  /// The crossed half-edges, each on the side of the face that the path leaves. Empty if one triangle contains both
  /// vertices.
  std::vector<HalfedgeHandle> crossings;
};

/// A place where the shortest path in a strip turns around a vertex on the strip's border.
struct StripTurn {
  std::size_t crossing = 0;  // index of a crossing at the vertex
  VertexHandle vertex;
  bool is_left = false;  // the vertex is on the left side of the strip
  double angle = 0;      // angle by which the path turns towards the vertex, radians in [0, pi]
};

struct StripPath {
  MeshPath path;
  double length = 0;
  std::vector<StripTurn> turns;
};

/// Returns the strip beside a path of edges, on the side of the smaller angle at each vertex.
Strip strip_beside(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& edge_path);

/// Returns the strip with one change: it passes the vertex of `turn`, an interior vertex, on the other side.
Strip pass_on_other_side(const HalfEdgeMesh& mesh, const Strip& strip, const StripTurn& turn);

/// Returns the shortest path in a strip. If an end of a crossed edge is on a wire, the path stays a quarter of the edge
/// away from this end.
StripPath shortest_in_strip(const HalfEdgeMesh& mesh, const WireMask& wires, const Strip& strip);

}  // namespace wirewarp
