// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/optimize/box_quadratic.h"

#include <Eigen/Cholesky>
#include <vector>

namespace wirewarp {

Eigen::VectorXd minimize_quadratic_in_box(const Eigen::VectorXd& g, const Eigen::MatrixXd& b,
                                          const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  constexpr int kMaxFactorizations = 50;  // with 25, five of 835 random pieces change; with 100, none
  Eigen::VectorXd d = Eigen::VectorXd::Zero(g.size()), slope = g;
  double value = 0;
  Eigen::LLT<Eigen::MatrixXd> factor;
  std::vector<int> factored;  // variables of the factored submatrix
  for (int i = 0; i < kMaxFactorizations; ++i) {
    // A step may change all variables, except variables at a bound that the model pushes outward.
    std::vector<int> free;
    for (int k = 0; k < g.size(); ++k) {
      const bool is_active = (d[k] <= lower[k] && slope[k] > 0) || (d[k] >= upper[k] && slope[k] < 0);
      if (!is_active) free.push_back(k);
    }
    if (free.empty()) break;
    if (free != factored) {
      factor.compute(b(free, free));
      factored = free;
    }
    // If rounding leaves B without a Cholesky factor, the step is a scaled steepest descent step.
    Eigen::VectorXd newton = -slope(free).cwiseQuotient(b.diagonal()(free));
    if (factor.info() == Eigen::Success) newton = factor.solve(-slope(free));
    const double predicted = -slope(free).dot(newton);
    if (!(predicted > 1e-16 * std::abs(value))) break;
    Eigen::VectorXd step;
    double down = 0;  // slope along the step, which ends in the box
    for (double t = 1; t > 1e-10 && !(down < 0); t /= 2) {
      step = d;
      step(free) += t * newton;
      step = step.cwiseMax(lower).cwiseMin(upper) - d;
      down = slope.dot(step);
    }
    if (!(down < 0)) break;
    const Eigen::VectorXd change_of_slope = b * step;
    const double curvature = step.dot(change_of_slope);
    const double share = curvature > -down ? -down / curvature : 1;  // share of the step at which the model is smallest
    d = (d + share * step).cwiseMax(lower).cwiseMin(upper);
    slope += share * change_of_slope;
    value += share * (down + share * curvature / 2);
  }
  return d;
}

}  // namespace wirewarp
