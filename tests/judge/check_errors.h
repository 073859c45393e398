// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// The error is of a fault in the mesh itself.
bool is_of_mesh(ErrorCode code);

/// The error of piece `number` fits it: its topology, its outline, its wires, and what it names.
void check_error(Judged& judged, int number);

}  // namespace wirewarp::test
