// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/optimize/box_quadratic.h"

#include <Eigen/Cholesky>
#include <vector>

namespace wirewarp {

Eigen::VectorXd minimize_quadratic_in_box(const Eigen::VectorXd& g, const Eigen::MatrixXd& b,
                                          const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  const auto model = [&](const Eigen::VectorXd& d) { return g.dot(d) + d.dot(b * d) / 2; };
  constexpr int kMaxFactorizations = 50;
  Eigen::VectorXd d = Eigen::VectorXd::Zero(g.size());
  for (int i = 0; i < kMaxFactorizations; ++i) {
    const Eigen::VectorXd slope = g + b * d;
    std::vector<int> free;  // the others are at a bound that the model pushes against: the active set
    for (int k = 0; k < g.size(); ++k) {
      const bool is_active = (d[k] <= lower[k] && slope[k] > 0) || (d[k] >= upper[k] && slope[k] < 0);
      if (!is_active) free.push_back(k);
    }
    if (free.empty()) break;
    const Eigen::LLT<Eigen::MatrixXd> factor(b(free, free));
    Eigen::VectorXd newton = -slope(free).cwiseQuotient(b.diagonal()(free));
    if (factor.info() == Eigen::Success) newton = factor.solve(-slope(free));
    const double promised = -slope(free).dot(newton);
    if (!(promised > 1e-16 * std::abs(model(d)))) break;
    Eigen::VectorXd trial;
    double t = 1;
    for (; t > 1e-10; t /= 2) {
      trial = d;
      trial(free) += t * newton;
      trial = trial.cwiseMax(lower).cwiseMin(upper);
      if (model(trial) < model(d)) break;
    }
    if (t <= 1e-10) break;
    d = trial;
  }
  return d;
}

}  // namespace wirewarp
