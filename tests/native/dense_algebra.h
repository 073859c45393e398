// SPDX-License-Identifier: GPL-3.0-or-later
// Dense matrices, to compare with. Compiled once: Eigen's products and decompositions are what a test takes longest to
// compile.
#pragma once

#include <Eigen/Core>

namespace wirewarp::test {

/// a·b of large matrices.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// spaceᵀ·a·space.
Eigen::MatrixXd reduced_to(const Eigen::MatrixXd& space, const Eigen::MatrixXd& a);

/// Orthonormal columns that span the columns of full rank.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

/// Orthonormal columns that span {x: a x = 0}.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& a);

/// x with a x = b; a is regular.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Of a symmetric matrix, in ascending order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// λ of symmetric·x = λ·metric·x, in ascending order; the metric is positive definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& metric);

}  // namespace wirewarp::test
