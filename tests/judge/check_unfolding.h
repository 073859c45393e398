// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Whether a piece's outline may have other lengths than on the surface.
bool has_other_outline(const Judged& judged, const Piece& piece);

/// Checks a piece whose surface unfolds into the plane without overlap, with its own lengths: it must be flat, without
/// an error and nearly undistorted. The paper's methods need this only if they converge.
void check_unfolding(Judged& judged, const Piece& piece);

}  // namespace wirewarp::test
