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

/// A chart of a coupled group, or the only one.
struct CoupledChart {
  const Chart& chart;
  SolvedChart& solved;   // where to begin: near exact lengths, its multipliers, upright if of a cloth
  bool is_nominal_good;  // it has a good shape with these seams at h = ease, as far as is known
  std::optional<ClothOnChart> cloth;
  int max_factorizations;  // of solved.report.factorizations

  int factorizations_left() const { return max_factorizations - solved.report.factorizations; }
};

/// Refines one of the charts, by index, with these seams at the lengths that the given chart asks for. Returns an
/// injective shape, or none.
using RefineAlone = std::function<std::optional<RefineResult>(std::size_t index, const Chart& fixed,
                                                              RefineBudget& budget, const StopToken& stop)>;

/// From scratch, without the cloth's stretch.
std::optional<RefineResult> refine_injective(const Chart& chart, const InternalOptions& options, RefineBudget& budget,
                                             const StopToken& stop);

struct CouplingOutcome {
  bool is_coupled;
  bool ran_out;                 // of factorizations: more were wanted
  std::vector<char> is_folded;  // per chart, if coupled: flipped or overlapping
};

/// Finds the lengths of these seams, and the shapes with them, of the least objective together. A chart that is flipped
/// or overlaps with the lengths found is refined again with them by refine_alone. The charts are not coupled, and keep
/// their shapes, if no common lengths are found, or if a chart stays so although all were good at h = ease: good pieces
/// come before less distortion. Their reports count what was spent in any case: each factorization of the coupled
/// charts counts for each of them.
CouplingOutcome couple_charts(const std::vector<CoupledChart>& charts, const InternalOptions& options,
                              const RefineAlone& refine_alone, const StopToken& stop);

}  // namespace wirewarp
