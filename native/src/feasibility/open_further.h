// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts for a surface without handles whose outline is too short for its area.
#pragma once

#include "feasibility/piece_outlines.h"

namespace wirewarp {

/// A cut from the boundary, or on a closed surface from one far end, to the vertex farthest from there.
CutMask slit_to_far_end(const HalfEdgeMesh& mesh);

/// A cut that leaves one piece, if its outline is then long enough, else the best of it and some cuts in two halves.
CutMask opened_or_halved(const HalfEdgeMesh& mesh, const CutMask& opening);

}  // namespace wirewarp
