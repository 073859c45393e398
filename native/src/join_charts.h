// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "internal_options.h"
#include "solved_chart.h"
#include "stop_token.h"

namespace wirewarp {

/// One of the charts that seams which give hold together.
struct ChartToJoin {
  const Chart& chart;
  SolvedChart& solved;                               // with exact lengths
  const std::optional<FlattenError>& settled_error;  // set: it has none with these seams at h = ease; here they are as
                                                     // long as it would have them alone
};

/// The lengths of these seams, and the shapes with them, of the least objective together. Where no common lengths are
/// found, those at h = ease are left, and the charts that have no shape then get their error. A chart that turns over
/// or covers itself with the lengths found is solved anew with them alone; where that does not help and all were good
/// at h = ease, they stay so.
void join_charts(const std::vector<ChartToJoin>& charts, const InternalOptions& options, const StopToken& stop);

}  // namespace wirewarp
