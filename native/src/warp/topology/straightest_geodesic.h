// SPDX-License-Identifier: GPL-3.0-or-later
// The straightest geodesic from a vertex (paper III-A and references [41] and [42] of the paper). It is straight across
// edges, and has equal surface angles on its left and right at vertices.
#pragma once

#include <optional>

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Follows the straightest geodesic that leaves the start of `reference` at `angle` radians counter-clockwise from
/// `reference`. The path ends at the first vertex or edge of a wire or boundary. Returns nullopt if the geodesic comes
/// back to a triangle or vertex that it has passed, so a path has at most as many points as the mesh has faces and
/// vertices. If the start is on the outline, the angle must lead into one of its faces.
std::optional<MeshPath> trace_straightest(const HalfEdgeMesh& mesh, const WireMask& wires, HalfedgeHandle reference,
                                          double angle);

}  // namespace wirewarp
