// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Cuts through all handles and between all boundary loops, after which the chart is a disk: the shortest such cuts by
/// a tree of shortest paths and a tree of faces (Erickson, Har-Peled 2004). On a closed surface the shortest found from
/// some points of it. Nothing for a disk, and for a closed surface without handles. No cut runs along a forbidden edge:
/// what these leave no way through stays closed.
CutMask cut_to_disk(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
