// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "charts/chart.h"
#include "internal_options.h"
#include "mesh/edge_table.h"
#include "refine/refine_budget.h"
#include "solved_chart.h"
#include "stop_token.h"

namespace wirewarp {

/// What all charts of a run have in common.
struct Run {
  const FlattenInput& input;
  const InternalOptions& options;
};

/// Throws FlattenError where flatten() refuses the whole input. The table refers to the input's faces.
EdgeTable check_request(const FlattenInput& input, const Options& options);

/// What flatten() makes of these charts of an input in the middle of its material. The token is polled in this thread.
/// Throws Stopped.
FlattenResult flatten_charts(Charts charts, const Run& run, const StopToken& stop);

/// The layout of a chart with a mesh, or why it has none. budget: what several trials of the chart may spend together,
/// of which the error names options.max_factorizations.
SolvedChart solve_chart(const Chart& chart, const Run& run, RefineBudget& budget, const StopToken& stop);

/// The same with its elastic seams at h = ease.
SolvedChart solve_chart_with_fixed_seams(const Chart& chart, const Run& run, RefineBudget& budget,
                                         const StopToken& stop);

/// Seams along which a chart lies flat that has no good shape without. Throws Stopped: what was found by then is not
/// what a whole search finds.
std::vector<VertexPair> propose_seams(const Chart& chart, const Run& run, const StopToken& stop);

/// Adds such seams to a layout that is flipped or overlaps itself. If the caller stops, it stays without.
void propose_seams_for_layout(const Chart& chart, const Run& run, const StopToken& stop, SolvedChart& solved);

/// A chart that the caller's no came before.
SolvedChart cancelled_chart();

}  // namespace wirewarp
