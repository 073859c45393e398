// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_state.h"

#include "newton/retract_to_lengths.h"

namespace wirewarp {

RefineState::RefineState(const RefineTask& refine_task, const RefinementStart& start,
                         const RefinementLimits& refinement_limits)
    : task(refine_task),
      problem(task, refinement_limits.injectivity, start.uv),
      limits(refinement_limits),
      now(problem.iterate_at(start.uv)),
      multipliers(start.multipliers) {
  if (multipliers.size() == 0) multipliers.setZero(problem.constraints().size());
}

bool RefineState::factorize(const Convexity& convexity) {
  if (!system) system.emplace(task.chart, problem.objective(), problem.constraints(), now.uv, limits.stop);
  limits.budget.spend(1);
  return system->factorize(now.uv, multipliers, convexity, limits.stop);
}

bool RefineState::evaluate(RefineIterate& trial) const {
  if (limits.stop.is_stopped()) return false;
  trial.variation = problem.constraints().within_tolerance(trial.variation);
  if (!retract_to_lengths(problem.constraints(), *system, trial.variation, trial.uv, limits.stop)) return false;
  if (problem.objective().longest_step(now.uv, trial.uv - now.uv) < 1) return false;
  trial.value = problem.objective().value(trial.uv);
  return true;
}

}  // namespace wirewarp
