// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

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

}  // namespace wirewarp::test
