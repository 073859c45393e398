// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "feasibility/piece_outlines.h"

namespace wirewarp {

/// A cut from the boundary, or on a closed surface from one far end, to the vertex farthest from there.
CutMask slit_to_far_end(const HalfEdgeMesh& mesh);

}  // namespace wirewarp
