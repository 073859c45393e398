// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "newton/newton_system.h"
#include "newton/refine_problem.h"

namespace wirewarp {

inline constexpr Convexity kExactHessian{Curvature::exact, true};
inline constexpr Convexity kConvexHessian{Curvature::convex, false};
inline constexpr Convexity kLaplacian{Curvature::none, false};

enum class StepOutcome {
  accepted,
  rejected,   // the Hessian is not positive, or no step goes down as predicted
  converged,  // what a step is predicted to gain is not worthwhile
};

/// What the steps of refine_shape work on: the shape at hand, and the linear system of its last factorization.
struct RefineState {
  RefineState(const RefineTask& refine_task, const RefinementStart& start, const RefinementLimits& refinement_limits);
  RefineState(const RefineState&) = delete;  // the system refers to the problem
  RefineState& operator=(const RefineState&) = delete;

  bool may_go_on() const { return limits.budget.allows() && limits.stop.may_go_on(); }
  double worthwhile_decrease() const { return problem.worthwhile_decrease(now); }

  /// f and its gradient at the shape at hand.
  void update_gradient() { now.value = problem.objective().value_and_gradient(now.uv, gradient); }

  int num_factorizations() const { return system ? system->num_factorizations() : 0; }

  /// The system at the shape at hand; false where the Hessian is not positive on the tangent space of the lengths.
  bool factorize(const Convexity& convexity);

  /// Takes the trial back to exact lengths, and to its f; false where that fails, or something forbidden lies on the
  /// way, or the caller stopped.
  bool evaluate(RefineIterate& trial) const;

  const RefineTask task;
  RefineProblem problem;
  std::optional<NewtonSystem> system;  // from the first factorization on: shapes without strain need none
  RefinementLimits limits;
  RefineIterate now;
  Positions2 gradient;          // of f
  Eigen::VectorXd multipliers;  // λ
  int iterations = 0;
};

}  // namespace wirewarp
