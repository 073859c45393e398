// SPDX-License-Identifier: GPL-3.0-or-later
// The straightest geodesic from a vertex (paper III-A, its [41], [42]): straight across edges, and with equal surface
// angles on its left and right at vertices.
#pragma once

#include <optional>

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Sum of the face corners at a vertex, radians.
double total_angle(const HalfEdgeMesh& mesh, VertexHandle v);

/// Follows the straightest geodesic that leaves the start of `reference` at `angle` radians counter-clockwise from it,
/// up to the first vertex or edge of a wire or boundary: the path's last point. Empty if the geodesic comes back to a
/// triangle or vertex it has passed before, so that no path has more points than the mesh has faces and vertices.
/// The start is inside the chart, or the angle within its faces.
std::optional<MeshPath> trace_straightest(const HalfEdgeMesh& mesh, const WireMask& wires, HalfedgeHandle reference,
                                          double angle);

}  // namespace wirewarp
