// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/newton_system.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

enum class StepOutcome {
  accepted,
  rejected,   // the Hessian is not positive, or no step decreases f as predicted
  converged,  // the predicted gain of another step is not worthwhile
};

struct Iterate {
  Positions2 uv;              // one row per chart vertex
  Eigen::VectorXd variation;  // h, one per elastic part of the constraints
  double value = 0;           // f
};

/// A change of a layout that decreases a function.
struct Step {
  Positions2 d;
  Eigen::VectorXd variation;  // Δh
  double slope = 0;           // slope of the function along the step

  /// Returns the layout after a share of the step. The value of this layout is 0, because it is not computed.
  Iterate from(const Iterate& begin, double share = 1) const {
    return {begin.uv + share * d, begin.variation + share * variation, 0};
  }
};

/// The state that the steps of minimize() change: the current shape, and the linear system of its last factorization.
struct NewtonState {
  /// The problem must outlive the state.
  NewtonState(const Problem& the_problem, const Stage& the_stage, const Shape& start, const Control& the_control);
  NewtonState(const NewtonState&) = delete;  // not copied, because the system refers to the objective
  NewtonState& operator=(const NewtonState&) = delete;

  double length_error() const { return constraints.largest_error(constraints.residual(now.uv, now.variation)); }

  /// Returns whether f is so near its lower bound 0 that no step gains anything.
  bool is_isometric() const { return now.value <= isometric_value; }

  /// Returns the smallest predicted decrease of f that a step must have.
  double worthwhile_decrease() const;

  void update_gradient() { now.value = objective.value_and_gradient(now.uv, gradient); }

  int num_factorizations() const { return system ? system->num_factorizations() : 0; }

  /// Linearizes at the current shape. Returns false if the Hessian is not positive on the tangent space of the lengths.
  bool factorize(const Convexity& convexity);

  /// Moves the trial back to exact lengths and computes its f. Returns false if exact lengths are not found, if a
  /// forbidden flip or overlap occurs on the way, or if the caller stopped.
  bool evaluate(Iterate& trial) const;

  Solution solution(SolutionStatus status) const;

  const Problem& problem;
  const Stage stage;
  const Control control;
  const LengthConstraints constraints;
  FairShapeError objective;
  const double isometric_value;        // f below which a layout is isometric except for rounding
  std::optional<NewtonSystem> system;  // set by the first factorization; shapes without strain need none
  Iterate now;
  Positions2 gradient;
  Eigen::VectorXd multipliers;  // λ
  int iterations = 0;
};

}  // namespace wirewarp
