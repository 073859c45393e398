// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Returns whether the error is about a fault of the mesh itself.
bool is_of_mesh(ErrorCode code);

/// Checks that the error of piece `number` agrees with the piece's topology, outline and wires, and names only elements
/// of this piece.
void check_error(Judged& judged, int number);

}  // namespace wirewarp::test
