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
  /// lengths, without flips and overlaps. They are round and as small as possible: individual ones for a few wires,
  /// otherwise a shared one for all wires that the relaxed shape changes, or for all wires that change when they are
  /// free if that is far lower. Infinity for wires that no tolerance up to a half helps, and for more wires than can be
  /// tried. Empty if no such shape is found even with all wires free.
  std::vector<ProposedTolerance> tolerances{};
  /// The lengths contradict one another near every shape that was found, so that a longer search would not help.
  bool lengths_conflict = false;
};

/// Diagnoses a problem for which no shape with exact lengths was found. options.max_factorizations does not count here.
/// Throws Stopped.
LengthDiagnosis diagnose_lengths(Problem& problem, const InternalOptions& options, const StopToken& stop);

}  // namespace wirewarp
