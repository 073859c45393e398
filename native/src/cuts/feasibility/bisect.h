// SPDX-License-Identifier: GPL-3.0-or-later
// Finds cuts that divide a surface in two.
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Returns cuts that each separate two sets of faces:
/// - Three cuts follow planes through the center, perpendicular to the principal axes.
/// - Three cuts separate the faces whose normals point along a principal axis from the other faces.
/// - Two cuts separate the faces nearer to one far end of the surface from the faces nearer to another far end.
///
/// Each cut is shortened by moving it over single vertices. On coarse meshes, the cuts before shortening are returned,
/// too. No cut runs along a forbidden edge, because faces at a forbidden edge stay together. Empty cuts and duplicates
/// are dropped.
std::vector<CutMask> bisections(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
