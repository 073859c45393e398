// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// A chart with few faces, for quick evaluations of cuts. It has no super-elastic wires.
struct CoarseCopy {
  Chart chart;
  std::vector<VertexHandle> fine_vertex;  // of each coarse vertex
};

/// Returns a copy with about half as many faces as requested, or the chart itself if it has few. Throws Stopped.
CoarseCopy coarse_copy(const Chart& chart, double faces, const StopToken& stop);

}  // namespace wirewarp
