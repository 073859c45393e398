// SPDX-License-Identifier: GPL-3.0-or-later
// Measures whether flat pieces are easy to sew: their width, and how compact they are.
#pragma once

#include "cuts/propose/flat_pieces.h"
#include "surface/mesh/half_edge_mesh.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Largest error of flat_width() as a share of `most`.
constexpr double kWidthError = 0.07;

/// Returns the width of a flat shape at its narrowest place, but at most `most`.
/// - This is the diameter of the largest disk that can move through the shape.
/// - Scraps below a tenth of the area are ignored.
/// - The result differs from wirewarp.pattern.piece_width() by at most kWidthError times `most`.
double flat_width(const HalfEdgeMesh& mesh, const Positions2& uv, double most);

/// Returns whether a piece has a flat shape narrower than `narrowest`, in scene units. 0 allows any width.
bool is_narrow(const FlatPiece& piece, double narrowest);

int count_narrow(const FlatPieces& pieces, double narrowest);

/// Returns the area of a flat piece over the area of its convex hull. The ratio is low for long arms, a large hole or a
/// strong bend.
double solidity(const FlatPiece& piece);

}  // namespace wirewarp
