// SPDX-License-Identifier: GPL-3.0-or-later
// Of a cloth that is worn stretched: what becomes of lengths by the directions they have without the stretch.
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// L / l of an edge without an ease of its own, the mean over its sides.
double stretched_share(const Judged& judged, const Edge& edge);

/// A piece whose lengths all shrink by the directions they have in it is as good as without the stretch; one that
/// unfolds is what it is without, shrunk along weft and warp.
void check_even_stretch(Judged& judged, const Piece& piece);

}  // namespace wirewarp::test
