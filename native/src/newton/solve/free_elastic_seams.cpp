// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/free_elastic_seams.h"

#include "newton/refine_chart.h"
#include "newton/solve/piece_report.h"
#include "surface/charts/elastic_seams.h"

namespace wirewarp {
namespace {

/// Solves a chart with fixed seams from scratch, where no shape was found before, to get its error.
void solve_from_scratch(const GroupMember& member, const Run& run, const StopToken& stop) {
  SolvedChart& solved = member.solved;
  Budget budget(run.options.max_factorizations);
  budget.spend(solved.report.factorizations);
  solved = stop.is_stopped() ? cancelled_chart() : solve_chart(member.chart, run, budget, stop);
  solved.report.factorizations = budget.spent();
  if (!solved.error) report_fixed_seams(solved.report);
}

}  // namespace

void free_elastic_seams(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop) {
  const StopToken in_shape = stop.in("shape");
  GroupSolver solver(group, run, in_shape, false, [&](std::size_t k, Budget& budget) {
    Problem problem(group[k].chart, run.options.fairness);
    return refine_chart(problem, run.options, {budget, in_shape});
  });
  const GroupSolver::Outcome common = solver.solve_together();
  for (std::size_t k = 0; k < group.size(); ++k) {
    const GroupMember& member = group[k];
    if (common.is_solved) {
      if (common.is_folded[k] != 0) propose_seams_for_layout(member.chart, run, in_shape, member.solved);
      continue;
    }
    const FixedSeams fixed(member.chart);
    if (!member.is_nominal) {
      solve_from_scratch(member, run, in_shape);
      continue;
    }
    if (!solver.solve_alone(k).is_solved && in_shape.is_stopped()) {
      report_cancelled(member.solved.report);
      continue;
    }
    if (has_folds(member.chart, member.solved.uv)) propose_seams_for_layout(member.chart, run, in_shape, member.solved);
    report_fixed_seams(member.solved.report);
  }
}

}  // namespace wirewarp
