// SPDX-License-Identifier: GPL-3.0-or-later
// Why a sound chart has no flat shape.
#pragma once

#include "inner/inner_problem.h"

namespace wirewarp {

/// The caller's progress function asked to stop.
FlattenError cancelled();

/// The outline and the rigid wires contradict one another. solution: of Eq. (1), not feasible.
FlattenError infeasible_lengths(const Chart& chart, const WireNetwork& network, const std::vector<Wire>& wires,
                                const InnerSolution& solution);

/// The outline and the wires contradict one another, whatever shape they take. tolerances: that settle it, proven;
/// empty where the outline contradicts itself, for which a seam is proposed.
FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires,
                              std::vector<ProposedTolerance> tolerances);

/// A factorization broke down.
FlattenError not_solvable(const Chart& chart);

}  // namespace wirewarp
