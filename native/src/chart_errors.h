// SPDX-License-Identifier: GPL-3.0-or-later
// Why a sound chart has no flat shape.
#pragma once

#include "charts/chart.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// The caller's progress function asked to stop.
FlattenError cancelled();

/// No shape with all lengths was found. tolerances: with which the refined method found one; empty where none
/// do, for which a seam is proposed. ran_out: options.max_factorizations ended the search before all was tried.
FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, const Options& options,
                              std::vector<ProposedTolerance> tolerances, bool ran_out);

/// The paper's methods find no angles under which the wires close; the refined one keeps the lengths.
FlattenError needs_refinement(const Chart& chart);

/// A factorization broke down: faces differ too much in size, and the error names those that are small.
FlattenError not_solvable(const Chart& chart);

/// Rounding leaves no way for the helper wires of the paper's methods; the refined one needs none. The error names the
/// edges of wires and holes.
FlattenError not_joined(const Chart& chart);

}  // namespace wirewarp
