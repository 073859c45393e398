// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum of a convex quadratic function in a box.
#pragma once

#include <Eigen/Core>

namespace wirewarp {

/// argmin gᵀd + ½ dᵀBd over lower <= d <= upper, B positive definite, 0 in the box; the best d so far after 50 Newton
/// steps on what no bound holds. Where rounding leaves B without a Cholesky factor, these are steps down the slope.
Eigen::VectorXd minimize_quadratic_in_box(const Eigen::VectorXd& g, const Eigen::MatrixXd& b,
                                          const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

}  // namespace wirewarp
