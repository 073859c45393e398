// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Outline edges of a piece without an error that no wire runs along are exact, its inner edges are not torn.
void check_outline(Judged& judged, const Piece& piece);

/// Rigid wires are exact; the edges of each part of an elastic one change alike, within its tolerance about its ease.
/// So do all sides of each run along an outline between its junctions, but for eases of their own.
void check_wires(Judged& judged);

}  // namespace wirewarp::test
