// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// A chart with few faces, on which cuts are tried quickly. Super-elastic wires are left out.
struct CoarseCopy {
  Chart chart;
  std::vector<VertexHandle> fine_vertex;  // of each vertex
};

/// About half as many faces as are asked for; the chart itself where it has few. Throws Stopped.
CoarseCopy coarse_copy(const Chart& chart, double faces, const StopToken& stop);

}  // namespace wirewarp
