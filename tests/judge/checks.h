// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the judge: each adds sentences to `judged` about what it finds.
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Returns whether the error is about a fault of the mesh itself.
bool is_of_mesh(ErrorCode code);

/// Checks that the error of piece `number` agrees with the piece's topology, outline and wires, and names only elements
/// of this piece.
void check_error(Judged& judged, int number);

/// Returns whether a piece's outline may have other lengths than on the surface.
bool has_other_outline(const Judged& judged, const Piece& piece);

/// Checks that a piece whose surface unfolds into the plane without overlap, with its own lengths, has no error and
/// almost no distortion. Does not check the paper's methods if they did not converge.
void check_unfolding(Judged& judged, const Piece& piece);

/// Returns whether all lengths of a piece are guaranteed: it has no error, or an error that is reported only for exact
/// lengths.
bool keeps_lengths(const Piece& piece);

/// Checks that outline edges without a wire have exact lengths in a piece that keeps its lengths, and that its faces
/// stay connected at inner edges.
void check_outline(Judged& judged, const Piece& piece);

/// Checks that rigid wires have exact lengths, and that all edges of a part of an elastic wire have the same h, within
/// the tolerance around the ease of the wire. Along an outline, all sides of a run between junctions must have the same
/// h, apart from their own eases.
void check_wires(Judged& judged);

/// Returns L / l of an edge without an ease: the mean over its sides.
double stretched_share(const Judged& judged, const Edge& edge);

/// Checks that a piece whose lengths all shrink by their directions is as good as without the stretch. If the piece
/// unfolds, its shape must be the shape without the stretch, shrunk along weft and warp.
void check_even_stretch(Judged& judged, const Piece& piece);

/// Checks that pieces do not touch: their boxes are the gap apart and, if requested, in a row in their order.
void check_room(Judged& judged);

/// Checks that the direction chosen by Options::orientation is up in piece `number`, which has a layout.
void check_orientation(Judged& judged, int number);

/// Checks that two results of the same input that differ only in the placement of pieces have equal errors and shapes.
void check_same_shapes(Judged& judged, const FlattenResult& other);

}  // namespace wirewarp::test
