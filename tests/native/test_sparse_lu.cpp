// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <random>
#include <stdexcept>
#include <vector>

#include "inner/sparse_lu.h"

namespace wirewarp {
namespace {

/// A row-diagonally-dominant M-matrix with an unsymmetric pattern; only every tenth row is strictly dominant.
SparseLu::Matrix random_m_matrix(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> column(0, size - 1);
  std::uniform_real_distribution<double> weight(0.01, 1.0);
  std::vector<Eigen::Triplet<double, int>> entries;
  for (int i = 0; i < size; ++i) {
    double sum = i % 10 == 0 ? weight(random) : 0;
    const auto add = [&](int j) {
      const double w = weight(random);
      if (j == i) return;
      entries.emplace_back(i, j, -w);
      sum += w;
    };
    add((i + size - 1) % size);  // joins every row to a strictly dominant one
    for (int count = 0; count < 3; ++count) add(column(random));
    entries.emplace_back(i, i, sum);
  }
  SparseLu::Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Positions2 random_columns(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  return Positions2::NullaryExpr(size, 2, [&] { return coordinate(random); });
}

TEST(SparseLu, SolvesRandomMMatrices) {
  for (const int size : {1, 2, 7, 50, 400}) {
    const SparseLu::Matrix a =
        size == 1 ? SparseLu::Matrix(Eigen::Matrix<double, 1, 1>(3.0).sparseView()) : random_m_matrix(size, 5 + size);
    const Positions2 b = random_columns(size, 1);
    const SparseLu lu(a);
    Positions2 x = b;
    lu.solve(x);
    EXPECT_LT((a * x - b).cwiseAbs().maxCoeff(), 1e-13 * (1 + x.cwiseAbs().maxCoeff())) << size;
    Positions2 y = b;
    lu.solve_transposed(y);
    EXPECT_LT((a.transpose() * y - b).cwiseAbs().maxCoeff(), 1e-13 * (1 + y.cwiseAbs().maxCoeff())) << size;
  }
}

TEST(SparseLu, AgreesWithEigen) {
  const SparseLu::Matrix a = random_m_matrix(60, 11);
  const Positions2 b = random_columns(60, 2);
  Positions2 x = b;
  SparseLu(a).solve(x);
  Eigen::SparseLU<Eigen::SparseMatrix<double>> eigen(a);
  const Eigen::MatrixXd expected = eigen.solve(Eigen::MatrixXd(b));
  EXPECT_LT((x - expected).norm(), 1e-12 * expected.norm());
}

TEST(SparseLu, TransposedSolveIsTheAdjoint) {
  const SparseLu lu(random_m_matrix(300, 3));
  const Positions2 b = random_columns(300, 4), x = random_columns(300, 5);
  Positions2 inverse_b = b, adjoint_x = x;
  lu.solve(inverse_b);
  lu.solve_transposed(adjoint_x);
  const double scale = x.norm() * inverse_b.norm();
  EXPECT_NEAR(x.cwiseProduct(inverse_b).sum(), adjoint_x.cwiseProduct(b).sum(), 1e-12 * scale);
}

TEST(SparseLu, FillIsThatOfCholesky) {
  const SparseLu::Matrix a = random_m_matrix(400, 8);
  Eigen::SparseMatrix<double> symmetric = a + SparseLu::Matrix(a.transpose());
  for (int i = 0; i < symmetric.rows(); ++i) symmetric.coeffRef(i, i) += 1e3;  // positive definite
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(symmetric);
  const auto cholesky_fill = cholesky.matrixL().nestedExpression().nonZeros() - a.rows();
  EXPECT_EQ(SparseLu(a).fill(), static_cast<std::size_t>(cholesky_fill));
}

TEST(SparseLu, IndependentBlocksDoNotFill) {
  // Two paths of five vertices: without an edge between them elimination from the ends inward adds nothing.
  std::vector<Eigen::Triplet<double, int>> entries;
  for (int i = 0; i < 10; ++i) entries.emplace_back(i, i, 2.0);
  for (const int i : {0, 1, 2, 3, 5, 6, 7, 8}) {
    entries.emplace_back(i, i + 1, -1.0);
    entries.emplace_back(i + 1, i, -0.5);
  }
  SparseLu::Matrix a(10, 10);
  a.setFromTriplets(entries.begin(), entries.end());
  EXPECT_EQ(SparseLu(a).fill(), 4u + 4u);
}

TEST(SparseLu, RefusesSingularMatrix) {
  // A closed graph: no row is strictly dominant, (1, 1) is in the kernel.
  Eigen::Matrix2d singular;
  singular << 1, -1, -1, 1;
  EXPECT_THROW(SparseLu(singular.sparseView()), std::domain_error);
}

}  // namespace
}  // namespace wirewarp
