// SPDX-License-Identifier: GPL-3.0-or-later
// Dense linear algebra for comparison. It is compiled once, because Eigen's products and decompositions take most of a
// test's compile time.
#pragma once

#include <Eigen/Core>

namespace wirewarp::test {

/// The product a·b of large matrices.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// spaceᵀ·a·space.
Eigen::MatrixXd reduced_to(const Eigen::MatrixXd& space, const Eigen::MatrixXd& a);

/// An orthonormal basis of the span of the columns.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

/// An orthonormal basis of the null space {x: a x = 0}.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& a);

/// The solution x of a x = b; a is regular.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The eigenvalues of a symmetric matrix, in ascending order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// The eigenvalues λ of symmetric·x = λ·metric·x, in ascending order; the metric is positive definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& metric);

}  // namespace wirewarp::test
