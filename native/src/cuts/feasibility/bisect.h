// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts that divide a surface in two.
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Cuts between what lies before and behind, above and below, left and right of the middle, between what faces one way
/// and the other, and between what is nearer to the one or the other of two ends. Each as short as it gets by moving
/// over single vertices, and as it was drawn. None runs along a forbidden edge: faces that share one go to one side.
/// Twice the same, and empty ones, are left out.
std::vector<CutMask> bisections(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
