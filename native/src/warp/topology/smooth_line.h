// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth lines in place of paths of edges, ready to be cut into the mesh.
#pragma once

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// How far a smooth line may be from the path that it replaces.
enum class Nearness {
  touching,  // among the triangles that touch the path, for a geodesic would leave a bend that the cut is there for
  anywhere,  // the geodesic between the ends to which the path shrinks
};

/// The shortest line beside a path, with the same ends, which crosses no other lines. A crossing that moves to a vertex
/// bends the line there, so what lies between is made straight again, until no further one moves.
MeshPath smooth_line(const HalfEdgeMesh& mesh, const WireMask& lines, const std::vector<VertexHandle>& path,
                     Nearness nearness);

/// The largest angle by which a path turns at a point between its ends, inside the mesh, radians. At a vertex, angles
/// are shares of all of its angle, as on a cone.
double sharpest_turn(const HalfEdgeMesh& mesh, const MeshPath& path);

}  // namespace wirewarp
