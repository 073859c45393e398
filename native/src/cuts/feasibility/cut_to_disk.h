// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/feasibility/cut_mask.h"

namespace wirewarp {

/// Returns a short cut that opens all handles and connects all boundary loops (Erickson, Har-Peled 2004). The cut is
/// empty for disks and spheres. No cut follows a forbidden edge, so handles and separate loops may remain.
CutMask cut_to_disk(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
