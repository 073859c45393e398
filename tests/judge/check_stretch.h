// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the lengths of a cloth that is worn stretched: they depend on the directions without the stretch.
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Returns L / l of an edge without an ease of its own, the mean over its sides.
double stretched_share(const Judged& judged, const Edge& edge);

/// Checks a piece whose lengths all shrink by their directions: it is as good as without the stretch. A piece that
/// unfolds is the piece without the stretch, shrunk along weft and warp.
void check_even_stretch(Judged& judged, const Piece& piece);

}  // namespace wirewarp::test
