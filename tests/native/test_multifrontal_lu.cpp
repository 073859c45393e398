// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/SparseCore>
#include <random>
#include <stdexcept>
#include <vector>

#include "base/factorization_failed.h"
#include "cholesky_problems.h"
#include "dense_algebra.h"
#include "numerics/cholesky/multifrontal_lu.h"

namespace wirewarp::test_multifrontal_lu {
namespace {

using Matrix = MultifrontalLu::Matrix;

/// A row-diagonally-dominant M-matrix on a mesh, and the positions of the mesh's vertices. Only every tenth row is
/// strictly dominant.
struct LuProblem {
  explicit LuProblem(const CholeskyProblem& mesh, unsigned seed = 7) : positions(mesh.positions) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> weight(0.01, 1.0);
    const auto size = static_cast<int>(positions.rows());
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) entries.emplace_back(i, i, i % 10 == 0 ? weight(random) : 0);
    for (const auto& [a, b] : mesh.edges) {
      for (const auto& [row, column] : {std::pair(a, b), std::pair(b, a)}) {
        const double w = weight(random);
        entries.emplace_back(row, column, -w);
        entries.emplace_back(row, row, w);
      }
    }
    matrix.resize(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
  }

  Matrix matrix;
  Positions2 positions;
};

Positions2 random_columns(Eigen::Index size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  return Positions2::NullaryExpr(size, 2, [&] { return coordinate(random); });
}

TEST(MultifrontalLu, SolvesWithTheMatrixAndItsTranspose) {
  std::vector<const FrontKernels*> all_kernels{&kPlainKernels};
  if (has_avx2()) all_kernels.push_back(&kAvx2Kernels);
  for (const int n : {1, 2, 7, 20, 60}) {
    const LuProblem problem(mesh_problem(n, 1));
    const Matrix& a = problem.matrix;
    const Positions2 b = random_columns(a.rows(), 1);
    for (const FrontKernels* kernels : all_kernels) {
      const MultifrontalLu lu(a, problem.positions, false, {}, *kernels);
      Positions2 x = b;
      lu.solve(x);
      EXPECT_LT((a * x - b).cwiseAbs().maxCoeff(), 1e-13 * (1 + x.cwiseAbs().maxCoeff())) << n;
      Positions2 y = b;
      lu.solve_transposed(y);
      EXPECT_LT((a.transpose() * y - b).cwiseAbs().maxCoeff(), 1e-13 * (1 + y.cwiseAbs().maxCoeff())) << n;
    }
  }
}

TEST(MultifrontalLu, ResultsDoNotDependOnThreads) {
  const LuProblem problem(mesh_problem(60, 1));
  const Positions2 b = random_columns(problem.matrix.rows(), 3);
  Positions2 x = b, in_threads = b;
  MultifrontalLu(problem.matrix, problem.positions, false).solve(x);
  MultifrontalLu(problem.matrix, problem.positions, true).solve(in_threads);
  EXPECT_EQ(in_threads, x);
}

/// Each diagonal entry in turn is lowered slightly beyond the value at which the matrix is singular. If the entry is
/// lowered slightly less, the matrix is still an M-matrix.
TEST(MultifrontalLu, RefusesAPivotThatIsNotPositive) {
  LuProblem problem(mesh_problem(12, 1));
  const Eigen::Index size = problem.matrix.rows();
  const Eigen::MatrixXd inverse = test::solve(Eigen::MatrixXd(problem.matrix), Eigen::MatrixXd::Identity(size, size));
  for (Eigen::Index i = 0; i < size; ++i) {
    const double diagonal = problem.matrix.coeff(i, i);
    problem.matrix.coeffRef(i, i) = diagonal - (1 - 1e-7) / inverse(i, i);
    EXPECT_NO_THROW(MultifrontalLu(problem.matrix, problem.positions)) << i;
    problem.matrix.coeffRef(i, i) = diagonal - (1 + 1e-7) / inverse(i, i);
    EXPECT_THROW(MultifrontalLu(problem.matrix, problem.positions), FactorizationFailed) << i;
    problem.matrix.coeffRef(i, i) = diagonal;
  }
}

TEST(MultifrontalLu, RefusesAPatternThatIsNotSymmetric) {
  Eigen::Matrix2d a;
  a << 1, -0.5, 0, 1;
  EXPECT_THROW(MultifrontalLu(a.sparseView(), Positions2::Zero(2, 2)), std::invalid_argument);
  Eigen::Matrix3d b;
  b << 2, -1, 0, 0, 2, -1, -1, 0, 2;
  EXPECT_THROW(MultifrontalLu(b.sparseView(), Positions2::Zero(3, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace wirewarp::test_multifrontal_lu
