// SPDX-License-Identifier: GPL-3.0-or-later
// A strip of triangles between two vertices and the shortest path inside it.
#pragma once

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Triangles from one with the corner `start` to one with the corner `end`, each once, each beside the next.
struct Strip {
  VertexHandle start;
  VertexHandle end;
  std::vector<HalfedgeHandle> crossings;  // each on the side whose face is left; empty: one triangle has both
};

/// Where the shortest path in a strip turns around a vertex at its rim.
struct StripTurn {
  std::size_t crossing = 0;  // one of those at the vertex
  VertexHandle vertex;
  bool is_left = false;  // of the strip
  double angle = 0;      // by which the path turns towards the vertex, radians in [0, pi]
};

struct StripPath {
  MeshPath path;
  double length = 0;
  std::vector<StripTurn> turns;
};

/// The strip beside a path of edges, on the side of the smaller angle at each vertex.
Strip strip_beside(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& edge_path);

/// The same strip, but around the other side of a vertex inside the mesh.
Strip pass_on_other_side(const HalfEdgeMesh& mesh, const Strip& strip, const StripTurn& turn);

/// The shortest path in a strip that crosses no edge nearer than a quarter of it to an end on a wire.
StripPath shortest_in_strip(const HalfEdgeMesh& mesh, const WireMask& wires, const Strip& strip);

}  // namespace wirewarp
