// SPDX-License-Identifier: GPL-3.0-or-later
// Finds out why no flat shape of a chart with all lengths was found: whether the lengths contradict one another, and
// which tolerances help.
#pragma once

#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "newton/problem.h"
#include "wirewarp/error.h"

namespace wirewarp {

struct LengthDiagnosis {
  /// Tolerances, sorted by wire, with which a flat shape without flips and overlaps was found. They are round and as
  /// small as possible.
  ///
  /// - Up to 8 wires have individual tolerances.
  /// - More wires share a tolerance: the wires that the relaxed shape changes.
  /// - Instead, all wires that change when they are free share a tolerance if it is less than half as large.
  /// - Infinite: no tolerance up to 50% helps, or there are too many wires to try.
  /// - Empty list: no shape was found even with all wires free.
  std::vector<ProposedTolerance> tolerances{};
  /// Whether the lengths contradict one another near the relaxed shape, so that a longer search would hardly help.
  bool lengths_conflict = false;
};

/// Returns the diagnosis of a problem for which no shape with exact lengths was found. The search may spend more
/// factorizations than options.max_factorizations. Throws Stopped and FactorizationFailed.
LengthDiagnosis diagnose_lengths(Problem& problem, const InternalOptions& options, const StopToken& stop);

}  // namespace wirewarp
