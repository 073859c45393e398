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

/// Finds seams along which a chart lies flat that has no good shape without them. Throws Stopped: what was found by
/// then is not what a whole search finds.
using ProposeSeams = std::function<std::vector<VertexPair>(const Chart& chart, const StopToken& stop)>;

/// What all charts of a run have in common.
struct Run {
  const FlattenInput& input;
  const InternalOptions& options;
  ProposeSeams propose_seams;  // empty: errors are not reported, so that nothing is proposed
};

/// The layout of a chart with a mesh, or why it has none. budget: what several trials of the chart may spend together,
/// of which the error names options.max_factorizations.
SolvedChart solve_chart(const Chart& chart, const Run& run, Budget& budget, const StopToken& stop);

/// The same with its elastic seams at h = ease.
SolvedChart solve_chart_with_fixed_seams(const Chart& chart, const Run& run, Budget& budget, const StopToken& stop);

/// By Run::propose_seams.
std::vector<VertexPair> propose_seams(const Chart& chart, const Run& run, const StopToken& stop);

/// Adds such seams to a layout that is flipped or overlaps itself. If the caller stops, it stays without.
void propose_seams_for_layout(const Chart& chart, const Run& run, const StopToken& stop, SolvedChart& solved);

/// A chart that the caller's no came before.
SolvedChart cancelled_chart();

}  // namespace wirewarp
