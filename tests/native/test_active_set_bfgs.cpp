// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "dense_algebra.h"
#include "numerics/optimize/active_set_bfgs.h"
#include "numerics/optimize/box_quadratic.h"

namespace wirewarp::test_active_set_bfgs {
namespace {

Eigen::VectorXd constant(int n, double value) { return Eigen::VectorXd::Constant(n, value); }

TEST(ActiveSetBfgs, ModelMinimumSatisfiesTheOptimalityConditions) {
  for (const int n : {1, 3, 20, 100}) {
    const Eigen::MatrixXd root = test::random_normal(n, n, 5);
    const Eigen::VectorXd g = test::random_normal(n, 1, 6);
    const Eigen::MatrixXd b = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
    const Eigen::VectorXd d = minimize_quadratic_in_box(g, b, constant(n, -0.1), constant(n, 0.2));
    const Eigen::VectorXd slope = g + b * d;
    for (int i = 0; i < n; ++i) {
      ASSERT_GE(d[i], -0.1);
      ASSERT_LE(d[i], 0.2);
      EXPECT_LT(d[i] > -0.1 ? slope[i] : 0, 1e-6);
      EXPECT_GT(d[i] < 0.2 ? slope[i] : 0, -1e-6);
    }
  }
}

TEST(ActiveSetBfgs, TheModelDecreasesEvenWithoutACholeskyFactor) {
  const Eigen::Matrix2d flat = Eigen::Matrix2d::Ones();
  ASSERT_NE(flat.llt().info(), Eigen::Success);
  const Eigen::Vector2d g(-1, -1);
  const Eigen::VectorXd d = minimize_quadratic_in_box(g, flat, constant(2, -2), constant(2, 2));
  EXPECT_NEAR(g.dot(d) + d.dot(flat * d) / 2, -0.5, 1e-6);
}

/// Returns 1 plus Rosenbrock's function, with the minimum 1 at (1, 1).
std::optional<ValueAndGradient> rosenbrock(const Eigen::VectorXd& x) {
  const double a = 1 - x[0], b = x[1] - x[0] * x[0];
  return ValueAndGradient{1 + a * a + 100 * b * b, Eigen::Vector2d(-2 * a - 400 * x[0] * b, 200 * b)};
}

TEST(ActiveSetBfgs, FindsAMinimumInside) {
  const BoxMinimum minimum =
      minimize_in_box(rosenbrock, constant(2, -2), constant(2, 2), Eigen::Vector2d(-1.2, 1), 1e-14, 200);
  EXPECT_TRUE(minimum.converged);
  EXPECT_NEAR(minimum.x[0], 1, 1e-5);
  EXPECT_NEAR(minimum.x[1], 1, 1e-5);
}

TEST(ActiveSetBfgs, AGoodGuessOfTheHessianSavesEvaluations) {
  const Eigen::Matrix2d hessian = (Eigen::Matrix2d() << 3, 1, 1, 200).finished();
  const Eigen::Vector2d minimum(0.3, -0.2), start(1, 1);
  const auto bowl = [&](const Eigen::VectorXd& x) {
    const Eigen::Vector2d slope = hessian * (x - minimum);
    return ValueAndGradient{1 + (x - minimum).dot(slope) / 2, slope};
  };
  const auto with = [&](const std::optional<Eigen::MatrixXd>& guess) {
    return minimize_in_box(bowl, constant(2, -2), constant(2, 2), start, 1e-14, 100, guess).evaluations;
  };
  EXPECT_EQ(with(hessian), 2);
  EXPECT_GT(with(std::nullopt), 2);
}

TEST(ActiveSetBfgs, FindsAMinimumAtABound) {
  // With x0 <= 0.5, the minimum is 1 + 0.25 at x0 = 0.5, x1 = 0.25.
  const BoxMinimum minimum =
      minimize_in_box(rosenbrock, constant(2, -2), Eigen::Vector2d(0.5, 2), Eigen::Vector2d(-1.2, 1), 1e-14, 200);
  EXPECT_TRUE(minimum.converged);
  EXPECT_EQ(minimum.x[0], 0.5);
  EXPECT_NEAR(minimum.x[1], 0.25, 1e-6);
  EXPECT_NEAR(minimum.value, 1.25, 1e-10);
}

TEST(ActiveSetBfgs, BacksOffFromPointsWhereTheFunctionIsUndefined) {
  int refused = 0;
  const auto log_barrier = [&](const Eigen::VectorXd& x) -> std::optional<ValueAndGradient> {
    if (x[0] <= 0) {
      ++refused;
      return std::nullopt;
    }
    return ValueAndGradient{1 + x[0] - std::log(x[0]), Eigen::VectorXd::Constant(1, 1 - 1 / x[0])};
  };
  const BoxMinimum minimum =
      minimize_in_box(log_barrier, constant(1, -100), constant(1, 100), constant(1, 50), 1e-12, 100);
  EXPECT_NEAR(minimum.x[0], 1, 1e-4);
  EXPECT_GT(refused, 0) << "the iteration never reaches the edge of the domain";
}

TEST(ActiveSetBfgs, StopsAtItsBudgetWithTheBestPoint) {
  const Eigen::Vector2d start(-1.2, 1);
  const BoxMinimum minimum = minimize_in_box(rosenbrock, constant(2, -2), constant(2, 2), start, 1e-14, 5);
  EXPECT_FALSE(minimum.converged);
  EXPECT_EQ(minimum.evaluations, 5);
  EXPECT_LE(minimum.value, rosenbrock(start)->value);
}

}  // namespace
}  // namespace wirewarp::test_active_set_bfgs
