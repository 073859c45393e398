// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/newton_step.h"

#include <cmath>
#include <utility>

#include "newton/newton_constants.h"
#include "numerics/optimize/line_search.h"

namespace wirewarp {
namespace {

/// A step that decreases f + λᵀc.
struct NewtonStep : Step {
  Eigen::VectorXd multipliers;  // λ at the end of the step
};

/// Returns the minimum of g·d + ½ d·H d for J d - T Δh = -c and h + Δh in its bounds. Solves for the change of λ, not
/// for λ, so that an old factor causes only small errors.
NewtonStep newton_step(const NewtonState& state) {
  const LengthConstraints& constraints = state.constraints;
  const Eigen::VectorXd residual = constraints.residual(state.now.uv, state.now.variation);
  Positions2 force = state.gradient;
  constraints.add_transposed(constraints.directions(state.now.uv), state.multipliers, force);
  const NewtonSystem::Reduced reduced = state.system->reduce(-force, -residual);
  const Eigen::SparseMatrix<double>& lengths = constraints.elastic_lengths();
  Eigen::VectorXd variation = state.system->choose_variation_change(
      lengths.transpose() * state.multipliers + reduced.pull, state.now.variation);
  const NewtonSystem::Solution solution = state.system->solve_on_wires(reduced, variation);
  NewtonStep step{{state.system->finish(solution.d), std::move(variation)}, state.multipliers + solution.multipliers};
  step.slope = force.cwiseProduct(step.d).sum() - state.multipliers.dot(lengths * step.variation);
  return step;
}

bool factorize_for_exact_lengths(NewtonState& state, bool is_near_minimum) {
  const auto try_to_factorize = [&](const Convexity& convexity) {
    state.control.stop.check();
    return state.control.budget.allows() && state.factorize(convexity);
  };
  if (!is_near_minimum) return try_to_factorize(kLaplacian);
  return try_to_factorize(kExactHessian) || try_to_factorize(kConvexHessian);
}

void move_along(const NewtonStep& step, NewtonState& state) {
  state.now = step.from(state.now);
  state.multipliers = step.multipliers;
  ++state.iterations;
}

/// Takes Newton steps with the current factor while their slope falls fast. Returns whether the remaining decrease is
/// not worthwhile. slope: slope of the last step.
bool take_steps_with_factor(NewtonState& state, double slope) {
  for (bool is_first = true; state.control.stop.may_go_on(); is_first = false) {
    state.update_gradient();
    const NewtonStep step = newton_step(state);
    const double fall = std::abs(step.slope / slope);
    if (!(fall < NewtonConstants::falls_fast)) break;
    slope = step.slope;
    // `left` is the estimated decrease of f that remains after this step.
    const double left = is_first ? std::abs(slope) : fall * std::abs(slope);
    const bool is_last = left < state.worthwhile_decrease();
    move_along(step, state);
    if (is_last) return true;
  }
  return false;
}

/// Takes more steps with the current factor. Keeps the steps only if they end at exact lengths and decrease f. slope:
/// slope of the last step.
StepOutcome go_on_with_factor(NewtonState& state, double slope) {
  const Iterate begin = state.now;
  const Eigen::VectorXd multipliers = state.multipliers;
  const bool is_last = take_steps_with_factor(state, slope);
  Iterate end = std::exchange(state.now, begin);
  if (state.evaluate(end) && end.value < begin.value) {
    state.now = std::move(end);
  } else {
    state.multipliers = multipliers;
  }
  return is_last ? StepOutcome::converged : StepOutcome::accepted;
}

}  // namespace

StepOutcome reach_exact_lengths(NewtonState& state, bool is_near_minimum) {
  if (state.length_error() <= LengthConstraints::kept) return StepOutcome::accepted;
  for (int i = 0; i < (is_near_minimum ? 2 : 1); ++i) {
    state.update_gradient();
    if (!factorize_for_exact_lengths(state, is_near_minimum)) break;
    const NewtonStep step = newton_step(state);
    const Iterate begin = state.now;
    move_along(step, state);
    const bool is_last = is_near_minimum && take_steps_with_factor(state, step.slope);
    state.control.stop.check();
    Iterate end = std::exchange(state.now, begin);
    const bool is_exact = state.evaluate(end);
    state.now = std::move(end);
    if (is_exact) return is_last ? StepOutcome::converged : StepOutcome::accepted;
  }
  return StepOutcome::rejected;
}

StepOutcome take_newton_step(NewtonState& state) {
  if (!state.factorize(kExactHessian)) return StepOutcome::rejected;
  const NewtonStep step = newton_step(state);
  const bool is_last = std::abs(step.slope) < state.worthwhile_decrease();
  Iterate trial = step.from(state.now);  // before the retraction to exact lengths
  const double enough = state.now.value + kSufficientDecrease * step.slope;
  const bool goes_down = state.evaluate(trial) && trial.value <= enough;
  if (goes_down) {
    state.now = std::move(trial);
    state.multipliers = step.multipliers;
  }
  if (is_last) return StepOutcome::converged;
  if (!goes_down) return StepOutcome::rejected;  // a trust region then chooses a better step than a line search
  const bool is_near = std::abs(step.slope) < NewtonConstants::near_minimum * state.now.value;
  return is_near ? go_on_with_factor(state, step.slope) : StepOutcome::accepted;
}

}  // namespace wirewarp
