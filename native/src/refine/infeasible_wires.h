// SPDX-License-Identifier: GPL-3.0-or-later
// Which wires cannot keep their lengths, and the tolerances under which they can.
#pragma once

#include "refine/refine_chart.h"

namespace wirewarp {

/// Tolerances by rising wire under which all lengths of the chart can be kept, proven by a flat shape that does, not
/// judged otherwise. On few wires if those serve, else one tolerance for all that change when free; rounded up to 0.1
/// %, and from 0.5 % on to 0.5 %. Infinity for a wire that no tolerance up to a half helps. Empty if no flat shape is
/// found even with all wires free. options.max_factorizations does not count here. refined: of the chart, not exact.
/// Stops early, with nothing, where go_on says so.
std::vector<ProposedTolerance> propose_tolerances(const Chart& chart, const Options& options,
                                                  const RefineResult& refined, const std::function<bool()>& go_on,
                                                  const Tuning& tuning);

}  // namespace wirewarp
