// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

#include "cholesky/multifrontal_cholesky.h"
#include "cholesky_problems.h"

namespace wirewarp {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return number(random); });
}

double largest_residual(const SparseMatrix& lower, const Eigen::MatrixXd& x, const Eigen::MatrixXd& b) {
  return (lower.selfadjointView<Eigen::Lower>() * x - b).cwiseAbs().maxCoeff();
}

std::vector<const FrontKernels*> all_kernels() {
  std::vector<const FrontKernels*> kernels{&kPlainKernels};
  if (has_avx2()) kernels.push_back(&kAvx2Kernels);
  return kernels;
}

class CholeskyOnProblem : public testing::TestWithParam<int> {};

TEST_P(CholeskyOnProblem, SolvesAsEigenDoes) {
  const CholeskyProblem problem = cholesky_problems()[static_cast<std::size_t>(GetParam())];
  SCOPED_TRACE(problem.name);
  const Eigen::MatrixXd b = random_matrix(problem.lower.rows(), 7, 3);
  const Eigen::SimplicialLLT<SparseMatrix> eigen(problem.lower);
  ASSERT_EQ(eigen.info(), Eigen::Success);
  const Eigen::MatrixXd expected = eigen.solve(b);
  for (const FrontKernels* kernels : all_kernels()) {
    MultifrontalCholesky cholesky(problem.lower, problem.tree(), problem.unknowns_per_vertex, 1, *kernels);
    ASSERT_TRUE(cholesky.factorize(problem.lower));
    Eigen::MatrixXd x = b;
    cholesky.solve_in_place(x);
    EXPECT_LT(largest_residual(problem.lower, x, b), 1e-11 * (1 + x.cwiseAbs().maxCoeff()));
    EXPECT_LT((x - expected).norm(), 1e-9 * expected.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(All, CholeskyOnProblem, testing::Range(0, static_cast<int>(cholesky_problems().size())));

}  // namespace
}  // namespace wirewarp
