// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 1 of the paper: BFGS with an active set of bounds. Knows a function and a box, nothing of meshes.
//
// Each step minimizes the quadratic model of the function over the box itself, so no iterate leaves it: the paper's
// penalty terms are zero all along, and the final check finds nothing to project.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace wirewarp {

struct ValueAndGradient {
  double value;
  Eigen::VectorXd gradient;
};

/// Empty where the function is not defined: the line search backs off.
using BoxFunction = std::function<std::optional<ValueAndGradient>(const Eigen::VectorXd& x)>;

struct BoxMinimum {
  Eigen::VectorXd x;
  double value = 0;
  int iterations = 0;
  int evaluations = 0;
  bool converged = false;  // the model predicts less than tolerance * value
};

/// Minimizes from a start in the box; throws std::bad_optional_access where the function is not defined there. Never
/// returns more than the start's value.
/// lower < upper, finite; tolerance: relative; function is called at most max_evaluations times. hessian: a guess at
/// the start, positive definite; without it a multiple of the identity.
BoxMinimum minimize_in_box(const BoxFunction& function, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                           const Eigen::VectorXd& start, double tolerance, int max_evaluations,
                           const std::optional<Eigen::MatrixXd>& hessian = {});

}  // namespace wirewarp
