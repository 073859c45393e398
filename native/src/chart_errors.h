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

/// A factorization broke down.
FlattenError not_solvable(const Chart& chart);

}  // namespace wirewarp
