// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/propose/flat_pieces.h"

namespace wirewarp {

/// Returns the share of its convex hull that a flat piece covers, 1 for a convex piece: low for pieces with long arms,
/// a large hole or a strong bend.
double solidity(const FlatPiece& piece);

}  // namespace wirewarp
