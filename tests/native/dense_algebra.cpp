// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_algebra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <random>

namespace wirewarp::test {

Eigen::MatrixXd random_normal(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd matrix(rows, columns);
  for (double& x : matrix.reshaped()) x = normal(random);
  return matrix;
}

Eigen::MatrixXd symmetric(const Eigen::SparseMatrix<double>& lower) {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a * b; }

Eigen::MatrixXd reduced_to(const Eigen::MatrixXd& space, const Eigen::MatrixXd& a) {
  return product(space.transpose(), product(a, space));
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(columns).householderQ() *
         Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& a) {
  return orthonormal(Eigen::FullPivLU<Eigen::MatrixXd>(a).kernel());
}

Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return Eigen::PartialPivLU<Eigen::MatrixXd>(a).solve(b);
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& metric) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, metric, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace wirewarp::test
