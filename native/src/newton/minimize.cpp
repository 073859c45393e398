// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/minimize.h"

#include <optional>

#include "base/attempt.h"
#include "newton/newton_constants.h"
#include "newton/newton_step.h"
#include "newton/trust_region.h"

namespace wirewarp {
namespace {

bool stays_flipped(const NewtonState& state) {
  return state.num_factorizations() >= NewtonConstants::patience && state.objective.count_flips(state.now.uv) > 0;
}

/// Takes steps that keep exact lengths, down to the minimum of f. outcome: outcome of the step that reached exact
/// lengths.
SolutionStatus descend(NewtonState& state, StepOutcome outcome) {
  const auto is_enough = [&] {
    return state.stage.target == Target::newton_step && state.objective.count_flips(state.now.uv) == 0;
  };
  TrustRegion trust_region;
  bool try_newton = true;
  while (outcome == StepOutcome::accepted && !state.is_isometric() && !stays_flipped(state) &&
         state.control.may_go_on()) {
    state.update_gradient();
    ++state.iterations;
    outcome = try_newton ? take_newton_step(state) : StepOutcome::rejected;
    if (outcome == StepOutcome::accepted && is_enough()) outcome = StepOutcome::converged;
    // A Newton step is rejected if the exact Hessian is not positive, or if f does not fall as predicted.
    if (outcome == StepOutcome::rejected && state.control.may_go_on()) {
      outcome = trust_region.take_step(state);
      try_newton = trust_region.was_inside();
    }
  }
  const bool is_at_minimum = outcome == StepOutcome::converged && state.stage.target == Target::minimum;
  const bool is_converged = is_at_minimum || state.is_isometric();
  return is_converged ? SolutionStatus::converged : SolutionStatus::stalled;
}

}  // namespace

Solution minimize(const Problem& problem, const Stage& stage, const Shape& start, const Control& control) {
  NewtonState state(problem, stage, start, control);
  const bool is_near_minimum = start.multipliers.size() > 0;
  const auto outcome = attempt([&] { return std::optional(reach_exact_lengths(state, is_near_minimum)); });
  if (!outcome) return state.solution(control.stop.is_stopped() ? SolutionStatus::cancelled : SolutionStatus::singular);
  if (*outcome == StepOutcome::rejected) return state.solution(SolutionStatus::infeasible);
  const auto status = attempt([&] { return std::optional(descend(state, *outcome)); });
  return state.solution(status.value_or(SolutionStatus::stalled));
}

Solution evaluate(const Problem& problem, const Stage& stage, const Shape& shape) {
  Budget none(0);
  const NewtonState state(problem, {stage.cloth, stage.lengths, Injectivity::none, stage.target}, shape, {none});
  if (state.length_error() > LengthConstraints::kept) return state.solution(SolutionStatus::infeasible);
  return state.solution(state.is_isometric() ? SolutionStatus::converged : SolutionStatus::stalled);
}

}  // namespace wirewarp
