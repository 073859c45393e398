// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarse_start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "newton/coarsen/prolong.h"
#include "newton/refine_chart.h"

namespace wirewarp {
namespace {

// Coarse edge length over fine edge length; 4 leaves a sixteenth of the faces. With 8, no test of coarse starts
// changes.
constexpr double kCoarsening = 4;
// Least ratio of coarse to fine edge length for which a coarse copy is made. The ratio 2 leaves a quarter of the faces.
// With more faces, the copy saves no time.
constexpr double kLeastCoarsening = 2;
// Largest ratio of coarse edge length to the shortest wavelength of the wires. Longer edges cannot follow the wires.
constexpr double kPerWiggle = 0.9;
// Largest number of factorizations for the coarse copy. At most half of the budget is spent, because the chart itself
// needs the rest. Half or twice this number changes no test of coarse starts.
constexpr int kMaxCoarseFactorizations = 30;

}  // namespace

std::optional<Shape> start_from_coarse(const Problem& problem, const Control& control) {
  const Chart& chart = problem.chart();
  const double fine = typical_edge_length(chart.mesh);
  const double wanted = std::min(kCoarsening * fine, kPerWiggle * problem.fairness() * std::sqrt(problem.area()));
  if (wanted < kLeastCoarsening * fine || !can_coarsen(chart)) return std::nullopt;
  const StopToken at_start([at_start = control.stop.in("start")](const char*) { return at_start.may_go_on(); });
  at_start.check();
  const CoarseChart coarse = coarsen(chart, problem.network(), wanted, at_start);
  at_start.check();
  Budget budget(control.budget, std::min(kMaxCoarseFactorizations, control.budget.left() / 2));
  Problem coarse_problem(coarse.chart, coarse.network, problem.fairness());
  InternalOptions from_scratch;
  from_scratch.large_chart = std::numeric_limits<std::size_t>::max();  // so that the copy is not coarsened again
  const Solution solution = refine_chart(coarse_problem, from_scratch, {budget, at_start});
  at_start.check();
  if (!solution.is_exact()) return std::nullopt;
  return Shape{prolong_positions(chart, problem.network(), coarse, solution.shape.uv),
               {},
               prolong_multipliers(coarse, solution.shape.multipliers)};
}

}  // namespace wirewarp
