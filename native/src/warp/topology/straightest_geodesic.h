// SPDX-License-Identifier: GPL-3.0-or-later
// The straightest geodesic from a vertex (paper III-A and references [41] and [42] of the paper). It is straight across
// edges, and has equal surface angles on its left and right at vertices.
#pragma once

#include <optional>

#include "warp/topology/split_chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Follows the straightest geodesic from the start of `reference` to the first wire or boundary. Returns nullopt if it
/// comes back to a triangle or vertex. angle: radians counter-clockwise from `reference`, into a face.
std::optional<MeshPath> trace_straightest(const HalfEdgeMesh& mesh, const WireMask& wires, HalfedgeHandle reference,
                                          double angle);

}  // namespace wirewarp
