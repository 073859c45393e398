// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Outline edges of a piece without an error are exact, its inner edges are not torn.
void check_outline(Judged& judged, const Piece& piece);

/// Rigid wires are exact; the edges of each part of an elastic one change alike, within its tolerance about its ease.
void check_wires(Judged& judged);

}  // namespace wirewarp::test
