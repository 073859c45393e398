// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Whether all lengths of a piece are guaranteed: it has no error, or one that is reported only if they are exact.
bool keeps_lengths(const Piece& piece);

/// Checks that outline edges without a wire are exact in a piece that keeps its lengths, and that inner edges are not
/// torn.
void check_outline(Judged& judged, const Piece& piece);

/// Checks that rigid wires are exact, and that the edges of each part of an elastic one have the same h within its
/// tolerance around its ease. The same holds for all sides of each run along an outline between junctions, except for
/// their own eases.
void check_wires(Judged& judged);

}  // namespace wirewarp::test
