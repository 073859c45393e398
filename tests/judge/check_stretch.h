// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the lengths for a fabric that is stretched when worn, which depend on the directions without the stretch.
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Returns L / l of an edge without an ease: the mean over its sides.
double stretched_share(const Judged& judged, const Edge& edge);

/// Checks that a piece whose lengths all shrink by their directions is as good as without the stretch. If the piece
/// unfolds, its shape must be the shape without the stretch, shrunk along weft and warp.
void check_even_stretch(Judged& judged, const Piece& piece);

}  // namespace wirewarp::test
