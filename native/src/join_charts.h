// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "internal_options.h"
#include "refine/refine_chart.h"
#include "solved_chart.h"
#include "stop_token.h"

namespace wirewarp {

/// One of the charts that seams which give hold together, or the only one.
struct ChartToJoin {
  const Chart& chart;
  SolvedChart& solved;  // where to begin: near exact lengths, its multipliers, upright if of a cloth
  bool is_settled;      // it has a good shape with these seams at h = ease, as far as is known
  std::optional<ClothOnChart> cloth;
};

/// The shape of one of the charts, by index, with these seams at the lengths that the given chart asks for: one that is
/// neither turned over nor over itself, or none.
using RefineAlone =
    std::function<std::optional<RefineResult>(std::size_t index, const Chart& settled, const StopToken& stop)>;

/// From scratch, without the cloth's stretch.
std::optional<RefineResult> refine_unfolded(const Chart& chart, const InternalOptions& options, const StopToken& stop);

struct JoinOutcome {
  bool is_joined;
  int factorizations;           // that led nowhere
  std::vector<char> is_folded;  // per chart, joined: turns over or covers itself
};

/// The lengths of these seams, and the shapes with them, of the least objective together. A chart that turns over or
/// covers itself with the lengths found is solved anew with them by refine_alone. Not joined, and left as they are,
/// where no common lengths are found, or where with them a chart stays folded although all were good at h = ease: good
/// pieces come before less distortion.
JoinOutcome join_charts(const std::vector<ChartToJoin>& charts, const InternalOptions& options,
                        const RefineAlone& refine_alone, const StopToken& stop);

}  // namespace wirewarp
