// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of the judge. Each check_ function adds a sentence to `judged` for every fault that it finds.
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Returns whether the error reports a fault of the mesh, not of its flat shape.
bool is_of_mesh(ErrorCode code);

/// Checks that the error of piece `number` agrees with the piece's topology, outline and wires, and names only elements
/// of this piece.
void check_error(Judged& judged, int number);

/// Returns whether eases or tolerances may give a piece's outline other lengths than on the surface.
bool has_other_outline(const Judged& judged, const Piece& piece);

/// Checks a piece whose surface unfolds into the plane without overlap, and whose outline has the lengths on the
/// surface. The piece must have no error and almost no distortion. Checks nothing for a stretched fabric, and
/// nothing for the refined method with a low limit on factorizations. The paper's methods are checked only if they
/// converged without an error.
void check_unfolding(Judged& judged, const Piece& piece);

/// Returns whether all lengths of a piece are guaranteed, because it has no error, or an error that is reported only
/// for exact lengths.
bool keeps_lengths(const Piece& piece);

/// Checks that outline edges without a wire have exact lengths, and that faces stay connected at inner edges. The piece
/// must keep its lengths.
void check_outline(Judged& judged, const Piece& piece);

/// Checks that rigid wires have exact lengths, and that all edges of a part of an elastic wire have the same length
/// variation h. This h must be within the tolerance around the wire's ease. Along an outline, all sides of a run
/// between junctions must have the same h, apart from their own eases.
void check_wires(Judged& judged);

/// Returns the target length of an edge without an ease, divided by its length on the surface. The target length of a
/// seam is the mean of its sides.
double stretched_share(const Judged& judged, const Edge& edge);

/// Checks a piece whose lengths shrink only by their directions. The piece must have no error if it has no error
/// without the stretch. If the piece unfolds, its shape must be the shape without the stretch, shrunk along weft and
/// warp.
void check_even_stretch(Judged& judged, const Piece& piece);

/// Checks that the boxes of pieces are at least the gap apart. With PieceLayout::row, also checks that the pieces are
/// in a row, in their order.
void check_room(Judged& judged);

/// Checks that the direction chosen by Options::orientation is up in piece `number`, which has a layout.
void check_orientation(Judged& judged, int number);

/// Checks that another result of the same input has equal errors and shapes. Only the placement of pieces may differ.
void check_same_shapes(Judged& judged, const FlattenResult& other);

}  // namespace wirewarp::test
