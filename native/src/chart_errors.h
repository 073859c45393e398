// SPDX-License-Identifier: GPL-3.0-or-later
// Why a sound chart has no flat shape.
#pragma once

#include "charts/chart.h"

namespace wirewarp {

/// The caller's progress function asked to stop.
FlattenError cancelled();

/// The outline and the wires contradict one another, whatever shape they take. tolerances: that settle it, proven with
/// the refined method; empty where the outline contradicts itself, for which a seam is proposed.
FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, Method method,
                              std::vector<ProposedTolerance> tolerances);

/// The paper's methods find no angles under which the wires close; the refined one keeps the lengths.
FlattenError needs_refinement(const Chart& chart);

/// A factorization broke down.
FlattenError not_solvable(const Chart& chart);

}  // namespace wirewarp
