// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_shape.h"

#include <utility>

#include "base/factorization_failed.h"
#include "newton/newton_step.h"
#include "newton/refine_constants.h"
#include "newton/trust_region.h"

namespace wirewarp {
namespace {

/// Flipped triangles that are not expected to open any more.
bool stays_flipped(const RefineState& state) {
  return state.num_factorizations() >= RefineConstants::patience &&
         state.problem.objective().count_flips(state.now.uv) > 0;
}

/// Steps from exact lengths, which all of them keep, to the least f. outcome: of the step to exact lengths.
ShapeStatus minimize(RefineState& state, StepOutcome outcome) {
  // f is at least 0, so nothing is left to gain.
  const auto is_isometric = [&] { return state.problem.is_isometric(state.now); };
  const auto is_enough = [&] {
    return state.task.target == Target::newton_step && state.problem.objective().count_flips(state.now.uv) == 0;
  };
  TrustRegion trust_region;
  bool try_newton = true;
  while (outcome == StepOutcome::accepted && !is_isometric() && !stays_flipped(state) && state.may_go_on()) {
    // 2. f and its gradient at the shape at hand.
    state.update_gradient();
    ++state.iterations;
    // 3. A Newton step, where the exact Hessian may be positive on the tangent space of the lengths.
    outcome = try_newton ? take_newton_step(state) : StepOutcome::rejected;
    if (outcome == StepOutcome::accepted && is_enough()) outcome = StepOutcome::converged;
    // 4. Where it is not, or the step does not go down as predicted: a step in a trust region.
    if (outcome == StepOutcome::rejected && state.may_go_on()) {
      outcome = trust_region.take_step(state);
      try_newton = trust_region.was_inside();
    }
  }
  return outcome == StepOutcome::converged || is_isometric() ? ShapeStatus::converged : ShapeStatus::stalled;
}

}  // namespace

RefinedShape refine_shape(const RefineTask& task, const RefinementStart& start, const RefinementLimits& limits) {
  RefineState state(task, start, limits);
  ShapeStatus status = ShapeStatus::infeasible;
  const auto ended_early = [&](ShapeStatus reason) { return status == ShapeStatus::stalled ? status : reason; };
  try {
    // 1. Exact lengths.
    const StepOutcome outcome = reach_exact_lengths(state, start.multipliers.size() > 0);
    if (outcome != StepOutcome::rejected) {
      status = ShapeStatus::stalled;
      status = minimize(state, outcome);
    }
  } catch (const Stopped&) {
    status = ended_early(ShapeStatus::cancelled);
  } catch (const FactorizationFailed&) {
    status = ended_early(ShapeStatus::singular);
  }
  RefinedShape shape = state.problem.describe(state.now);
  shape.multipliers = std::move(state.multipliers);
  shape.iterations = state.iterations;
  shape.factorizations = state.num_factorizations();
  shape.status = status;
  return shape;
}

RefinedShape evaluate_shape(const RefineTask& task, const RefinementStart& start) {
  const RefineProblem problem(task, Injectivity::none, start.uv);
  const RefineIterate at_start = problem.iterate_at(start.uv);
  RefinedShape shape = problem.describe(at_start);
  shape.multipliers = start.multipliers;
  if (shape.multipliers.size() == 0) shape.multipliers.setZero(problem.constraints().size());
  if (shape.length_error <= LengthConstraints::kept) {
    shape.status = problem.is_isometric(at_start) ? ShapeStatus::converged : ShapeStatus::stalled;
  }
  return shape;
}

}  // namespace wirewarp
