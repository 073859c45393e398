// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces paths of edges with smooth lines that can be cut into the mesh.
#pragma once

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Where a smooth line may be, compared with the path that it replaces.
enum class Nearness {
  touching,  // within the triangles that touch the path, so that intended bends of a cut remain
  anywhere,  // anywhere on the surface: the geodesic to which the path shrinks
};

/// Returns the shortest line that has the same ends as a path and crosses no other lines.
MeshPath smooth_line(const HalfEdgeMesh& mesh, const WireMask& lines, const std::vector<VertexHandle>& path,
                     Nearness nearness);

/// Returns the largest angle, radians, by which a path turns at an interior point. At a vertex, angles are scaled to a
/// total of 2 π, as on a cone.
double sharpest_turn(const HalfEdgeMesh& mesh, const MeshPath& path);

}  // namespace wirewarp
