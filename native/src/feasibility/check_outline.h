// SPDX-License-Identifier: GPL-3.0-or-later
// Before anything is solved: can the outline hold the piece at all?
#pragma once

#include "charts/chart.h"

namespace wirewarp {

/// The chart could have far too small a part of its area when flat.
bool is_outline_too_short(const Chart& chart);

/// boundary_too_short, with the seams that mend it.
FlattenError outline_too_short(const Chart& chart, std::vector<VertexPair> proposed_seams);

}  // namespace wirewarp
