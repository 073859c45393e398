// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of charts for which no flat shape was found.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// Returns the error of a piece that was not flat when the caller stopped.
FlattenError cancelled();

/// Adds seams to the error of a closed chart, or of a chart with handles. Returns any other error unchanged.
FlattenError with_proposed_seams(FlattenError error, std::vector<VertexPair> proposed_seams);

/// Returns the error of an outline that is too short to enclose the piece (surface/charts/isoperimetric.h).
FlattenError outline_too_short(const Chart& chart, std::vector<VertexPair> proposed_seams);

/// Returns the error of a chart for which no shape with all lengths was found. tolerances: tolerances with which the
/// refined method found a shape. ran_out: whether options.max_factorizations ended the search.
FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, const Options& options,
                              std::vector<ProposedTolerance> tolerances, bool ran_out);

/// Returns the error of a chart that no tolerances of its wires can make flat. proposed_seams: seams that help.
FlattenError infeasible_outline(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool ran_out);

/// Returns the error of a chart without a shape that has the lengths of the stretched fabric. is_good_unstretched:
/// whether less stretch may help, because the shape without stretch has no flips or overlaps.
FlattenError infeasible_stretch(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool is_good_unstretched, bool ran_out);

/// Returns the error of a chart that the paper's methods cannot flatten with all lengths, but the refined method can.
FlattenError needs_refinement(const Chart& chart);

/// Returns invalid_option if a wire along the outline has a tolerance, which WireWarping++ cannot use.
std::optional<FlattenError> elastic_outline(const Chart& chart, const std::vector<Wire>& wires);

/// Returns the error of a chart for which a factorization broke down. If its faces differ too much in size, the error
/// names the small faces.
FlattenError not_solvable(const Chart& chart);

/// Returns the error of a chart without a path for the helper wires of the paper's methods. Rounding errors cause this.
/// The error names the edges of wires and holes.
FlattenError not_joined(const Chart& chart);

}  // namespace wirewarp
