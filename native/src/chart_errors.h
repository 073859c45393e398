// SPDX-License-Identifier: GPL-3.0-or-later
// Why a sound chart has no flat shape.
#pragma once

#include "charts/chart.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// The caller's progress function asked to stop.
FlattenError cancelled();

/// A closed chart, or one with handles, with the seams that mend it. Any other error as it is.
FlattenError with_proposed_seams(FlattenError error, std::vector<VertexPair> proposed_seams);

/// The outline cannot hold the piece (feasibility/isoperimetric.h), with the seams that mend it.
FlattenError outline_too_short(const Chart& chart, std::vector<VertexPair> proposed_seams);

/// No shape with all lengths was found, with tolerances under which the refined method found one. ran_out:
/// options.max_factorizations ended the search before all was tried.
FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, const Options& options,
                              std::vector<ProposedTolerance> tolerances, bool ran_out);

/// No tolerances of its wires help a chart, but seams do.
FlattenError infeasible_outline(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool ran_out);

/// The paper's methods find no angles under which the wires close; the refined one keeps the lengths.
FlattenError needs_refinement(const Chart& chart);

/// Throws invalid_option where a wire gives the outline a tolerance, which WireWarping++ cannot use.
void check_outline_is_settled(const Chart& chart, const std::vector<Wire>& wires);

/// A factorization broke down: faces differ too much in size, and the error names those that are small.
FlattenError not_solvable(const Chart& chart);

/// Rounding leaves no way for the helper wires of the paper's methods; the refined one needs none. The error names the
/// edges of wires and holes.
FlattenError not_joined(const Chart& chart);

}  // namespace wirewarp
