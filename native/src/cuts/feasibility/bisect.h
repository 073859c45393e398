// SPDX-License-Identifier: GPL-3.0-or-later
// Finds cuts that divide a surface in two.
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Returns cuts that each divide a surface in two: across principal axes, between front and back as seen along such an
/// axis, or between far ends. No cut follows a forbidden edge.
std::vector<CutMask> bisections(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
