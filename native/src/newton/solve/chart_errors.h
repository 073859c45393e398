// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of charts that have no flat shape.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// Returns the error of a piece that was not flat when the caller's progress function asked to stop.
FlattenError cancelled();

/// Adds seams to the error of a closed chart, or of one with handles. Returns any other error unchanged.
FlattenError with_proposed_seams(FlattenError error, std::vector<VertexPair> proposed_seams);

/// Returns the error of an outline that is too short to enclose the piece (surface/charts/isoperimetric.h).
FlattenError outline_too_short(const Chart& chart, std::vector<VertexPair> proposed_seams);

/// Returns the error of a chart for which no shape with all lengths was found, with tolerances under which the refined
/// method found one. ran_out: options.max_factorizations ended the search while it was still getting closer.
FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, const Options& options,
                              std::vector<ProposedTolerance> tolerances, bool ran_out);

/// Returns the error of a chart that no tolerances of its wires help, with seams that do.
FlattenError infeasible_outline(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool ran_out);

/// Returns the error of a chart that no shape was found for with the lengths that the fabric's stretch sets.
/// is_good_unstretched: whether its shape without them has no flips or overlaps, so that less stretch may help.
FlattenError infeasible_stretch(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool is_good_unstretched, bool ran_out);

/// Returns the error of a chart whose wires the paper's methods cannot close, while the refined one keeps the lengths.
FlattenError needs_refinement(const Chart& chart);

/// Returns invalid_option if a wire gives the outline a tolerance, which WireWarping++ cannot use.
std::optional<FlattenError> elastic_outline(const Chart& chart, const std::vector<Wire>& wires);

/// Returns the error of a chart for which a factorization broke down. If its faces differ too much in size, the error
/// names the small ones.
FlattenError not_solvable(const Chart& chart);

/// Returns the error of a chart in which rounding leaves no way for the helper wires of the paper's methods. The
/// refined method needs none. The error names the edges of wires and holes.
FlattenError not_joined(const Chart& chart);

}  // namespace wirewarp
