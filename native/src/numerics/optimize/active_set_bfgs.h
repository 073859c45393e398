// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 1 of the paper: BFGS with an active set of bounds, for any function in a box.
//
// Each step minimizes the quadratic model of the function over the box, so iterates never leave the box. The paper's
// penalty terms are therefore always zero, and its final projection changes nothing.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace wirewarp {

struct ValueAndGradient {
  double value;
  Eigen::VectorXd gradient;
};

/// Returns nullopt at a point x for which the function is not defined. The line search then shortens the step.
using BoxFunction = std::function<std::optional<ValueAndGradient>(const Eigen::VectorXd& x)>;

struct BoxMinimum {
  Eigen::VectorXd x;
  double value = 0;
  int iterations = 0;
  int evaluations = 0;
  bool converged = false;  // the predicted decrease is at most tolerance * value
};

/// Minimizes a function in a box with finite bounds, lower < upper. Throws std::bad_optional_access if the function is
/// not defined at the start.
///
/// hessian: positive definite estimate at the start. Default: a multiple of the identity.
BoxMinimum minimize_in_box(const BoxFunction& function, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                           const Eigen::VectorXd& start, double tolerance, int max_evaluations,
                           const std::optional<Eigen::MatrixXd>& hessian = {});

}  // namespace wirewarp
