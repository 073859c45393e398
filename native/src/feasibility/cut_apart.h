// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "charts/chart.h"
#include "feasibility/cut_mask.h"

namespace wirewarp {

/// The charts between cut edges of a chart, with their parts of its wires. Their sources are the chart's own vertices,
/// faces and wire parts.
std::vector<Chart> cut_apart(const Chart& chart, const CutMask& cut);

}  // namespace wirewarp
