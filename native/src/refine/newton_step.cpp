// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/newton_step.h"

#include <cmath>
#include <utility>

#include "optimize/box_quadratic.h"
#include "refine/refine_constants.h"

namespace wirewarp {
namespace {

struct NewtonStep {
  Positions2 d;
  Eigen::VectorXd variation;    // Δh
  Eigen::VectorXd multipliers;  // λ at its end
  double slope;                 // of f along the step
};

/// The quadratic program min g·d + ½ d·H d, J d - T Δh = -c, h + Δh in its bounds. With d eliminated a dense one in Δh
/// is left, with the Hessian S and the gradient -Tᵀλ. It is solved for the change of λ, g + Jᵀλ in place of g: so a
/// factor from before the last step, with the J of then, is wrong in what is small.
NewtonStep newton_step(const RefineState& state) {
  const LengthConstraints& constraints = state.problem.constraints();
  const Eigen::VectorXd residual = constraints.residual(state.now.uv, state.now.variation);
  Positions2 force = state.gradient;
  constraints.add_transposed(constraints.directions(state.now.uv), state.multipliers, force);
  NewtonSystem::Solution solution = state.system.solve_on_wires(-force, -residual);
  const Eigen::SparseMatrix<double>& lengths = constraints.elastic_lengths();
  Eigen::VectorXd variation = Eigen::VectorXd::Zero(constraints.num_elastic());
  if (constraints.num_elastic() > 0) {
    const Eigen::VectorXd& tolerance = state.problem.tolerance();
    variation = minimize_quadratic_in_box(-(lengths.transpose() * (state.multipliers + solution.multipliers.col(0))),
                                          make_positive(hessian_h(lengths, state.dlambda_dh)),
                                          -tolerance - state.now.variation, tolerance - state.now.variation);
    solution.multipliers += state.dlambda_dh * variation;
    state.system.solve_on_wires(lengths * variation - residual, solution);
  }
  NewtonStep step{state.system.finish(solution.d), std::move(variation),
                  state.multipliers + solution.multipliers.col(0), 0};
  step.slope = force.cwiseProduct(step.d).sum() - state.multipliers.dot(lengths * step.variation - residual);
  return step;
}

/// Its end before the way back to exact lengths.
RefineIterate end_of(const NewtonStep& step, const RefineIterate& begin, double share = 1) {
  return {begin.uv + share * step.d, begin.variation + share * step.variation, 0};
}

bool goes_down(const RefineIterate& trial, const RefineIterate& now, double slope) {
  return trial.value <= now.value + RefineConstants::sufficient_ratio * slope;
}

bool factorize_for_exact_lengths(RefineState& state, bool is_near_minimum) {
  const auto try_to_factorize = [&](const Convexity& convexity) {
    state.limits.stop.check();
    return state.limits.budget.allows() && state.factorize(convexity);
  };
  if (!is_near_minimum) return try_to_factorize(kLaplacian);
  return try_to_factorize(kExactHessian) || try_to_factorize(kConvexHessian);
}

/// Newton steps with the factor from before a step with the given slope, as long as each leaves little to the next.
StepOutcome take_steps_with_factor(RefineState& state, double slope) {
  while (state.limits.stop.may_go_on()) {
    state.update_gradient();
    NewtonStep step = newton_step(state);
    if (std::abs(step.slope) > RefineConstants::falls_fast * std::abs(slope)) break;
    const bool is_last = std::abs(step.slope) < state.worthwhile_decrease();
    RefineIterate trial = end_of(step, state.now);
    const bool is_better = state.evaluate(trial) && goes_down(trial, state.now, step.slope);
    if (is_better) {
      ++state.iterations;
      state.now = std::move(trial);
      state.multipliers = std::move(step.multipliers);
    }
    if (is_last) return StepOutcome::converged;
    if (!is_better) break;
    slope = step.slope;
  }
  return StepOutcome::accepted;
}

}  // namespace

bool reach_exact_lengths(RefineState& state, bool is_near_minimum) {
  const auto is_kept = [&] { return state.problem.length_error(state.now) <= LengthConstraints::kept; };
  bool is_exact = is_kept();
  state.update_gradient();
  for (int i = 0; i < (is_near_minimum ? 2 : 1) && !is_exact; ++i) {
    if (!factorize_for_exact_lengths(state, is_near_minimum)) break;
    NewtonStep step = newton_step(state);
    RefineIterate trial = end_of(step, state.now);
    is_exact = state.evaluate(trial);
    state.now = std::move(trial);
    state.multipliers = std::move(step.multipliers);
    if (!is_exact) state.update_gradient();
    ++state.iterations;
  }
  return is_exact;
}

StepOutcome take_newton_step(RefineState& state) {
  if (!state.factorize(kExactHessian)) return StepOutcome::rejected;
  const NewtonStep step = newton_step(state);
  const bool is_last = std::abs(step.slope) < state.worthwhile_decrease();
  for (const double t : {1.0, 0.5}) {  // shorter steps are better taken in a trust region
    RefineIterate trial = end_of(step, state.now, t);
    if (!state.evaluate(trial) || !goes_down(trial, state.now, t * step.slope)) continue;
    const bool is_near = t == 1 && std::abs(step.slope) < RefineConstants::near_minimum * trial.value;
    state.now = std::move(trial);
    state.multipliers += t * (step.multipliers - state.multipliers);
    if (is_last) return StepOutcome::converged;
    return is_near ? take_steps_with_factor(state, step.slope) : StepOutcome::accepted;
  }
  return is_last ? StepOutcome::converged : StepOutcome::rejected;
}

}  // namespace wirewarp
