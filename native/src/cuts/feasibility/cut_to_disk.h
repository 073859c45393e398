// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Returns cuts through all handles and between all boundary loops, which turn the surface into a disk. They are the
/// shortest cuts that a tree of shortest paths and a tree of faces define (Erickson, Har-Peled 2004); on a closed
/// surface, the shortest from a few base points. A disk and a closed surface without handles are not cut. No cut runs
/// along a forbidden edge, so handles and loops that forbidden edges block stay uncut.
CutMask cut_to_disk(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
