// SPDX-License-Identifier: GPL-3.0-or-later
// Which wires cannot keep their lengths, and the tolerances under which they can.
#pragma once

#include "refine/refine_chart.h"

namespace wirewarp {

/// Tolerances by rising wire under which the refined method finds a good flat shape of the chart, proven by a run: all
/// lengths kept, nothing turned over, no overlap. Round and as small as serves: one for each of a few wires that give
/// way; else the same for all that give way, or for all that change when free if that is far lower; else infinity for
/// those that no tolerance up to a half helps. Empty if no good shape is found even with all wires free.
/// options.max_factorizations does not count here. refined: of the chart, not exact. Throws Stopped.
std::vector<ProposedTolerance> propose_tolerances(const Chart& chart, const InternalOptions& options,
                                                  const RefineResult& refined, const StopToken& stop);

}  // namespace wirewarp
