// SPDX-License-Identifier: GPL-3.0-or-later
// Whether flat pieces are easy to sew: their width, and how compact they are.
#pragma once

#include "cuts/propose/flat_pieces.h"
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

/// Returns whether a piece has a flat shape that is narrower than this. narrowest: 0 for any width.
bool is_narrow(const FlatPiece& piece, double narrowest);

/// Returns the number of such pieces.
int count_narrow(const FlatPieces& pieces, double narrowest);

/// Returns the share of its convex hull that a flat piece covers, 1 for a convex piece: low for pieces with long arms,
/// a large hole or a strong bend.
double solidity(const FlatPiece& piece);

}  // namespace wirewarp
