// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/mesh/half_edge_mesh.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Largest error of flat_width() as a share of `most`.
constexpr double kWidthError = 0.07;

/// Returns the narrowest width of a flat shape, but at most `most`: the diameter of the largest disk that can move
/// through it. Disks of this width and of all smaller ones cover at least half of the shape's area in one part. Other
/// parts may only be scraps of less than a tenth of the area. The result differs from wirewarp.pattern.piece_width() by
/// at most 7% of `most`. uv: one row per vertex. The result does not depend on how the shape is turned or mirrored,
/// unless two vertices are equally far from the centroid.
double flat_width(const HalfEdgeMesh& mesh, const Positions2& uv, double most);

/// Returns whether a flat shape is wide enough. narrowest: 0 for any width.
bool has_room(const HalfEdgeMesh& mesh, const Positions2& uv, double narrowest);

}  // namespace wirewarp
