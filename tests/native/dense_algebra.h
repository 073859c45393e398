// SPDX-License-Identifier: GPL-3.0-or-later
// Dense linear algebra for comparison. It is compiled once, because Eigen's products and decompositions take most of a
// test's compile time.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace wirewarp::test {

/// Returns normally distributed numbers with mean 0 and variance 1.
Eigen::MatrixXd random_normal(Eigen::Index rows, Eigen::Index columns, unsigned seed);

/// Returns the symmetric matrix with this lower triangle.
Eigen::MatrixXd symmetric(const Eigen::SparseMatrix<double>& lower);

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns spaceᵀ·a·space.
Eigen::MatrixXd reduced_to(const Eigen::MatrixXd& space, const Eigen::MatrixXd& a);

/// Returns an orthonormal basis of the span of the columns.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

/// Returns an orthonormal basis of the null space {x: a x = 0}.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& a);

/// Returns the solution x of a x = b. a must be regular.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns eigenvalues in ascending order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// Returns the eigenvalues λ of symmetric·x = λ·metric·x, in ascending order. metric must be positive definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& metric);

}  // namespace wirewarp::test
