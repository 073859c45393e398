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

/// Checks that a piece has no error and almost no distortion if its surface unfolds without overlap. Checks nothing if
/// has_other_outline() is true, if the fabric is stretched, or if the solver may stop early.
void check_unfolding(Judged& judged, const Piece& piece);

/// Returns whether all lengths of a piece are guaranteed. They are if the piece has no error, or if it has an error
/// that is reported only for shapes with exact lengths.
bool keeps_lengths(const Piece& piece);

/// Checks that outline edges without a wire have exact lengths, and that faces stay connected at inner edges. The piece
/// must keep its lengths.
void check_outline(Judged& judged, const Piece& piece);

/// Checks that one length variation, within the tolerance around the wire's ease, applies to
///
/// - all edges of each part of a wire, and
/// - all sides of each run along an outline, apart from their eases.
void check_wires(Judged& judged);

/// Returns the target length of an edge, without any ease, divided by its length on the surface. For a seam, returns
/// the mean of this ratio on its sides.
double stretched_share(const Judged& judged, const Edge& edge);

/// Checks a piece in which every length shrinks by the share of its direction:
///
/// - It has no error if it has none without the stretch.
/// - If it unfolds, its shape is the unstretched shape, shrunk along weft and warp.
void check_even_stretch(Judged& judged, const Piece& piece);

/// Checks that the boxes of pieces are at least the gap apart. With PieceLayout::row, also checks that the pieces are
/// in a row, in their order.
void check_room(Judged& judged);

/// Checks that the direction chosen by Options::orientation is up in piece `number`, which has a layout.
void check_orientation(Judged& judged, int number);

/// Checks that another result of the same input has equal errors and shapes. Only the placement of pieces may differ.
void check_same_shapes(Judged& judged, const FlattenResult& other);

}  // namespace wirewarp::test
