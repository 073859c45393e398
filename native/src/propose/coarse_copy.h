// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "charts/chart.h"
#include "stop_token.h"

namespace wirewarp {

/// A chart with few faces, on which cuts are tried quickly. Super-elastic wires are left out.
struct CoarseCopy {
  Chart chart;
  std::vector<VertexHandle> fine_vertex;  // of each vertex
};

/// The chart itself where it has few faces. Throws Stopped.
CoarseCopy coarse_copy(const Chart& chart, const StopToken& stop);

}  // namespace wirewarp
