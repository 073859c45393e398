// SPDX-License-Identifier: GPL-3.0-or-later
// Minimization of a convex quadratic function in a box.
#pragma once

#include <Eigen/Core>

namespace wirewarp {

/// Returns argmin gᵀd + ½ dᵀBd over lower <= d <= upper, for B positive definite and 0 in the box. After 50 Newton
/// steps on the free variables, returns the best d so far.
Eigen::VectorXd minimize_quadratic_in_box(const Eigen::VectorXd& g, const Eigen::MatrixXd& b,
                                          const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

}  // namespace wirewarp
