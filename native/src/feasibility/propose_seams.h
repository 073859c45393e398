// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "charts/chart.h"

namespace wirewarp {

/// Edges of the input along which a chart that cannot lie flat should be cut: through its handles and between its
/// loops, so that it becomes a disk, or in from its only loop; in two halves where it stays too closed otherwise.
std::vector<VertexPair> propose_seams(const Chart& chart);

/// The error of a chart with the seams that mend it, in its sentence too, if it is closed or has handles; any other
/// error as it is.
FlattenError with_proposed_seams(FlattenError error, const Chart& chart);

}  // namespace wirewarp
