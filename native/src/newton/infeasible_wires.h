// SPDX-License-Identifier: GPL-3.0-or-later
// Why a chart has no flat shape with all lengths: do they contradict one another, and which tolerances help?
#pragma once

#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "newton/problem.h"
#include "wirewarp/error.h"

namespace wirewarp {

struct LengthDiagnosis {
  /// By rising wire. Under them the refined method finds a good flat shape of the chart, proven by a run: all lengths
  /// kept, nothing flipped, no overlap. Round, and as small as works: one for each of a few wires that give way, else
  /// the same for all that give way, or for all that change when free if that is far lower, else infinity for those
  /// that no tolerance up to a half helps and for more wires than can be tried. Empty if no good shape is found even
  /// with all wires free.
  std::vector<ProposedTolerance> tolerances{};
  /// The lengths contradict one another near every shape that was found, so that a longer search would not help.
  bool lengths_conflict = false;
};

/// Diagnoses a problem for which no shape with exact lengths was found. options.max_factorizations does not count here.
/// Throws Stopped.
LengthDiagnosis diagnose_lengths(Problem& problem, const InternalOptions& options, const StopToken& stop);

}  // namespace wirewarp
