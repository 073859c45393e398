// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts that divide a surface in two.
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Returns cuts that divide the faces by three planes through the center, by the direction of their normals along the
/// same three axes, and by the nearer of two far ends of the surface, for two pairs of ends. Each cut is shortened by
/// moving it over single vertices. On coarse meshes, the original cut is returned, too. No cut runs along a forbidden
/// edge: faces at a forbidden edge stay together. Empty cuts and duplicates are dropped.
std::vector<CutMask> bisections(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
