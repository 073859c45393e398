// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "newton/control.h"
#include "newton/solved_chart.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Finds seams for a chart that has no good shape without them. Throws Stopped if the caller stops, because an
/// interrupted search would return other seams.
using ProposeSeams = std::function<std::vector<VertexPair>(const Chart& chart, const StopToken& stop)>;

struct Run {
  const FlattenInput& input;
  const InternalOptions& options;
  ProposeSeams propose_seams;  // empty if errors are not shown and therefore need no seams
};

/// Returns the layout of a chart with faces, or its error. budget: factorizations left for all trials of the chart
/// together. Errors do not name this number, but the limit that the user set, Options::max_factorizations.
SolvedChart solve_chart(const Chart& chart, const Run& run, Budget& budget, const StopToken& stop);

/// Returns the seams that Run::propose_seams finds, or no seams if Run::propose_seams is empty.
std::vector<VertexPair> seams_for(const Chart& chart, const Run& run, const StopToken& stop);

/// Adds proposed seams to a layout that is flipped or overlaps itself, unless the caller stops.
void propose_seams_for_layout(const Chart& chart, const Run& run, const StopToken& stop, SolvedChart& solved);

/// Returns the result for a chart that was not started before the caller canceled.
SolvedChart cancelled_chart();

}  // namespace wirewarp
