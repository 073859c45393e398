// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Returns a cut that turns the surface into a disk: it runs through all handles, and connects all boundary loops. The
/// cut is the shortest that a tree of shortest paths and a tree of faces define (Erickson, Har-Peled 2004). On a closed
/// surface, it is the shortest of the cuts through a few base points. A disk and a closed surface without handles are
/// not cut. No cut runs along a forbidden edge, so some handles and loops remain if forbidden edges block them.
CutMask cut_to_disk(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
