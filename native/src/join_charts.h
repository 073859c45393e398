// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "internal_options.h"
#include "solved_chart.h"
#include "stop_token.h"

namespace wirewarp {

/// One of the charts that seams which give hold together.
struct ChartToJoin {
  const Chart& chart;
  SolvedChart& solved;  // where to begin: with exact lengths, its multipliers, upright if of a cloth
  bool is_settled;      // with these seams at h = ease; else as long as the chart would have them alone
};

struct JoinOutcome {
  bool is_joined;
  int factorizations;           // that led nowhere
  std::vector<char> is_folded;  // per chart, joined: turns over or covers itself
};

/// The lengths of these seams, and the shapes with them, of the least objective together. A chart that turns over or
/// covers itself with the lengths found is solved anew with them alone. Not joined, and left as they are, where no
/// common lengths are found, or where with them a chart stays folded although all were good at h = ease: good pieces
/// come before less distortion.
JoinOutcome join_charts(const std::vector<ChartToJoin>& charts, const InternalOptions& options, const StopToken& stop);

}  // namespace wirewarp
