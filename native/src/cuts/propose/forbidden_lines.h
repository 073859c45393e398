// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/cut_mesh.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Returns whether lines of a cut mesh cross an edge of no_seam or no_crossing, or follow an edge of no_seam. Lines may
/// pass through vertices of such edges.
bool has_forbidden_lines(const CutMesh& cut, const CutOptions& cut_options);

}  // namespace wirewarp
