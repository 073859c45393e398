// SPDX-License-Identifier: GPL-3.0-or-later
// Finds out why a chart has no flat shape with all lengths: whether they contradict one another, and which tolerances
// help.
#pragma once

#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "newton/problem.h"
#include "wirewarp/error.h"

namespace wirewarp {

struct LengthDiagnosis {
  /// Tolerances by rising wire, under which a run of the refined method found a flat shape of the chart with all
  /// lengths, without flips and overlaps. They are round and as small as possible. A few wires have individual
  /// tolerances. More wires share one tolerance: all wires that the relaxed shape changes or, if that makes the
  /// tolerance far lower, all wires that change when they are free. The tolerance is infinite for wires that no
  /// tolerance up to one half helps, and if there are more wires than can be tried. Empty if no such shape is found
  /// even with all wires free.
  std::vector<ProposedTolerance> tolerances{};
  /// The lengths contradict one another near every shape that was found, so that a longer search would not help.
  bool lengths_conflict = false;
};

/// Diagnoses a problem for which no shape with exact lengths was found. options.max_factorizations does not count here.
/// Throws Stopped.
LengthDiagnosis diagnose_lengths(Problem& problem, const InternalOptions& options, const StopToken& stop);

}  // namespace wirewarp
