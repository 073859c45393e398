// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarse_start.h"

#include <algorithm>
#include <cmath>

#include "newton/coarsen/prolong.h"
#include "newton/refine_chart.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kCoarsening = 4;       // length of a coarse edge over that of a fine one: a sixteenth of the faces
constexpr double kLeastCoarsening = 2;  // a quarter of the faces: with more the coarse chart costs what it saves
constexpr double kPerWiggle = 0.9;      // length of a coarse edge over the shortest wavelength of wires, at most:
                                        // longer ones cannot bend as the wires do
constexpr int kMaxCoarseFactorizations = 30;  // and half of what is left: the chart itself needs some

}  // namespace

std::optional<RefinementStart> start_from_coarse(const RefineTask& task, RefineBudget& budget, const StopToken& stop) {
  const Chart& chart = task.chart;
  const double fine = typical_edge_length(chart.mesh);
  const double wanted = std::min(kCoarsening * fine, kPerWiggle * task.fairness * std::sqrt(surface_area(chart.mesh)));
  if (wanted < kLeastCoarsening * fine || !can_coarsen(chart)) return std::nullopt;
  const StopToken at_start([at_start = stop.in("start")](const char*) { return at_start.may_go_on(); });
  at_start.check();
  const CoarseChart coarse = coarsen(chart, task.network, wanted, at_start);
  at_start.check();
  RefineBudget coarse_budget(budget, std::min(kMaxCoarseFactorizations, budget.left() / 2));
  const RefinedShape shape =
      refine_from_scratch({coarse.chart, coarse.network, task.fairness}, coarse_budget, at_start).shape;
  at_start.check();
  if (!shape.is_exact()) return std::nullopt;
  return RefinementStart{prolong_positions(chart, task.network, coarse, shape.uv),
                         prolong_multipliers(coarse, shape.multipliers)};
}

}  // namespace wirewarp
