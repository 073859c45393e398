// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// A piece's outline may get, or gets, other lengths than those of the surface.
bool has_other_outline(const Judged& judged, const Piece& piece);

/// A piece whose surface unfolds into the plane, with every length as it is and without covering itself, must be found
/// flat without an error and hardly distorted: always by the refined method, and by the paper's where they converge.
void check_unfolding(Judged& judged, const Piece& piece);

}  // namespace wirewarp::test
