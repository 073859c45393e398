// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "charts/chart.h"
#include "feasibility/cut_mask.h"

namespace wirewarp {

/// All edges of a cut, one line after the other: each from where cuts end or meet to the next such vertex, then the
/// rings.
HalfEdgeChain chains_of(const HalfEdgeMesh& mesh, const CutMask& cut);

}  // namespace wirewarp
