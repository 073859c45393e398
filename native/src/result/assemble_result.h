// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the result from layouts: measures pieces, checks guarantees, reports seams and wires.
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "newton/solved_chart.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Measures every chart that has a layout, as seen from outside even if options.mirror says that layouts are mirrored.
/// With options.cloth, adds the fabric's energy. Throws Stopped.
FlattenResult assemble_result(const FlattenInput& input, const Charts& charts, std::vector<SolvedChart> solved_charts,
                              const Options& options, const StopToken& stop = {});

}  // namespace wirewarp
