// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Returns a short cut that turns the surface into a disk: it opens all handles, and connects all boundary loops. The
/// cut is empty if the surface is a disk, or closed without handles. No cut runs along a forbidden edge, so some
/// handles and loops remain if forbidden edges block them. The cut is found with a tree of shortest paths and a tree of
/// faces (Erickson, Har-Peled 2004).
CutMask cut_to_disk(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
