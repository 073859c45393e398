// SPDX-License-Identifier: GPL-3.0-or-later
// From layouts to the result: pieces measured, guarantees checked, seams and wires reported.
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "newton/solved_chart.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Measures every chart that has a layout. options.mirror: the layouts are handed over mirrored, and measured as seen
/// from outside; options.cloth: what it costs is measured, too. Throws Stopped.
FlattenResult assemble_result(const FlattenInput& input, const Charts& charts, std::vector<SolvedChart> solved_charts,
                              const Options& options, const StopToken& stop = {});

}  // namespace wirewarp
