// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/optimize/active_set_bfgs.h"

#include <algorithm>

#include "numerics/optimize/box_quadratic.h"
#include "numerics/optimize/line_search.h"

namespace wirewarp {
namespace {

/// Applies a BFGS update, with Powell's damping, so that B stays positive definite.
void update_hessian(const Eigen::VectorXd& step, Eigen::VectorXd change, Eigen::MatrixXd& b) {
  constexpr double kDamping = 0.2;  // Powell's value
  const Eigen::VectorXd b_step = b * step;
  const double curvature = step.dot(b_step);
  if (step.dot(change) < kDamping * curvature) {
    const double share = (1 - kDamping) * curvature / (curvature - step.dot(change));
    change = share * change + (1 - share) * b_step;
  }
  b += change * change.transpose() / step.dot(change) - b_step * b_step.transpose() / curvature;
}

/// Returns the position of a parabola's minimum, clamped to [0.1, 0.5]. The parabola has the value 0 and the given
/// slope at 0, and the value `rise` at 1.
double shorter_by(double slope, double rise) { return std::clamp(-slope / (2 * (rise - slope)), 0.1, 0.5); }

}  // namespace

BoxMinimum minimize_in_box(const BoxFunction& function, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                           const Eigen::VectorXd& start, double tolerance, int max_evaluations,
                           const std::optional<Eigen::MatrixXd>& hessian) {
  // Largest entry of the first steepest descent step. Later steps follow B, so half or twice this value changes no
  // test of elastic wires.
  constexpr double kFirstStep = 0.02;
  constexpr double kSmallestStep = 1e-5;  // share of a direction; reached after at most 17 reductions
  BoxMinimum best;
  best.x = start;
  ValueAndGradient here = function(start).value();
  best.value = here.value;
  best.evaluations = 1;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(start.size(), start.size());
  Eigen::MatrixXd b = hessian ? *hessian : identity * (here.gradient.lpNorm<Eigen::Infinity>() / kFirstStep);
  while (best.evaluations < max_evaluations) {
    if (here.gradient.isZero(0)) {
      best.converged = true;
      break;
    }
    const Eigen::VectorXd direction = minimize_quadratic_in_box(here.gradient, b, lower - best.x, upper - best.x);
    const double slope = here.gradient.dot(direction);
    const double predicted = -slope - direction.dot(b * direction) / 2;
    if (predicted <= tolerance * best.value) {
      best.converged = true;
      break;
    }
    std::optional<ValueAndGradient> there;
    Eigen::VectorXd trial;
    double t = 1;
    while (t > kSmallestStep && best.evaluations < max_evaluations) {
      trial = (best.x + t * direction).cwiseMax(lower).cwiseMin(upper);
      there = function(trial);
      ++best.evaluations;
      if (there && there->value <= best.value + kSufficientDecrease * t * slope) break;
      t *= there ? shorter_by(slope * t, there->value - best.value) : 0.5;
      there.reset();
    }
    if (!there) break;
    const Eigen::VectorXd step = trial - best.x;
    const Eigen::VectorXd change = there->gradient - here.gradient;
    if (best.iterations == 0 && !hessian && step.dot(change) > 0) {
      b = identity * (change.squaredNorm() / step.dot(change));
    }
    update_hessian(step, change, b);
    best.x = trial;
    best.value = there->value;
    here = std::move(*there);
    ++best.iterations;
  }
  return best;
}

}  // namespace wirewarp
