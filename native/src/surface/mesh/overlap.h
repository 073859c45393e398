// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the faces of a flat piece that overlap.
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/mesh/half_edge_mesh.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Penetration that counts as overlap, divided by the diagonal of the piece. It is far above rounding errors, and far
/// below the precision of scissors.
inline constexpr double kRelativeOverlapDepth = 1e-9;

/// Returns the faces that overlap another face of the same piece, in increasing order. Throws Stopped.
///
/// faces: m by 3, rows of uv, consistently oriented
/// on_boundary: one flag per face, true if it has a boundary edge
/// uv: n by 2, finite, scene units
/// relative_depth: largest penetration that does not count as overlap, divided by the diagonal of the piece
///
/// Touching faces do not overlap. For a crumpled piece, the time grows with the square of the number of faces.
std::vector<int> find_overlapping_faces(const Triangles& faces, const std::vector<bool>& on_boundary,
                                        const Positions2& uv, double relative_depth = kRelativeOverlapDepth,
                                        const StopToken& stop = {});

/// Returns one flag per face, true if it has a boundary edge.
std::vector<bool> faces_on_boundary(const HalfEdgeMesh& mesh);

}  // namespace wirewarp
