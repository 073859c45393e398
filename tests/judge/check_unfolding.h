// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Returns whether a piece's outline may have other lengths than on the surface.
bool has_other_outline(const Judged& judged, const Piece& piece);

/// Checks that a piece whose surface unfolds into the plane without overlap, with its own lengths, has no error and
/// almost no distortion. Does not check the paper's methods if they did not converge.
void check_unfolding(Judged& judged, const Piece& piece);

}  // namespace wirewarp::test
