// SPDX-License-Identifier: GPL-3.0-or-later
// Checks steps in a ball by the conditions for a global minimum of a quadratic (Gay; Sorensen): for some σ >= 0,
//
//   (H + σG) d = -g on the space,   σ = 0 or |d|_G = Δ,   H + σG positive semidefinite on the space
//
// d: step, H: Hessian, g: gradient, G: metric, Δ: radius of the ball, space: null space of the constraints
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>

#include "base/factorization_failed.h"
#include "dense_algebra.h"
#include "newton/lanczos_trust_region.h"

namespace wirewarp::test_lanczos_trust_region {
namespace {

constexpr int kUnknowns = 14, kConstraints = 4;

struct Problem {
  Problem(unsigned seed, double shift) {
    const Eigen::MatrixXd a = test::random_normal(kUnknowns, kUnknowns, seed),
                          b = test::random_normal(kUnknowns, kUnknowns, seed + 100);
    hessian = a + a.transpose() + shift * Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
    metric = test::product(b, b.transpose()) + Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
    constraints = test::random_normal(kConstraints, kUnknowns, seed + 200);
    gradient = test::random_normal(kUnknowns, 1, seed + 300);
    space = test::null_space(constraints);
  }

  LanczosTrustRegion model(int max_size) const {
    return LanczosTrustRegion([this](const Eigen::VectorXd& d) -> Eigen::VectorXd { return hessian * d; },
                              [this](Eigen::VectorXd& r) { return precondition(r); }, gradient, max_size);
  }

  Eigen::VectorXd precondition(Eigen::VectorXd& r) const {
    Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(kUnknowns + kConstraints, kUnknowns + kConstraints);
    kkt.topLeftCorner(kUnknowns, kUnknowns) = metric;
    kkt.bottomLeftCorner(kConstraints, kUnknowns) = constraints;
    kkt.topRightCorner(kUnknowns, kConstraints) = constraints.transpose();
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(kUnknowns + kConstraints);
    rhs.head(kUnknowns) = r;
    const Eigen::VectorXd solution = test::solve(kkt, rhs);
    r -= constraints.transpose() * solution.tail(kConstraints);
    return solution.head(kUnknowns);
  }

  double value(const Eigen::VectorXd& d) const { return gradient.dot(d) + 0.5 * d.dot(hessian * d); }

  Eigen::VectorXd eigenvalues_in_space(const Eigen::MatrixXd& m) const {
    return test::eigenvalues(test::reduced_to(space, m), test::reduced_to(space, metric));
  }

  Eigen::MatrixXd hessian, metric, constraints, space;
  Eigen::VectorXd gradient;
};

TEST(LanczosTrustRegion, FindsTheMinimumOfAnIndefiniteQuadraticInEveryBall) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Problem problem(seed, 0);
    ASSERT_LT(problem.eigenvalues_in_space(problem.hessian).minCoeff(), 0);
    const LanczosTrustRegion model = problem.model(kUnknowns);
    EXPECT_EQ(model.size(), kUnknowns - kConstraints);
    EXPECT_NEAR(model.lowest_curvature(), problem.eigenvalues_in_space(problem.hessian).minCoeff(), 1e-8);
    for (const double radius : {1e-4, 0.01, 0.3, 1.0, 10.0, 1e3}) {
      const ModelStep step = model.step(radius);
      EXPECT_FALSE(step.is_inside);
      EXPECT_LT((problem.constraints * step.d).norm(), 1e-9 * step.d.norm());
      EXPECT_NEAR(std::sqrt(step.d.dot(problem.metric * step.d)), radius, 1e-8 * radius);
      EXPECT_NEAR(step.length, radius, 1e-9 * radius);
      EXPECT_NEAR(step.decrease, -problem.value(step.d), 1e-8 * step.decrease);
      // Computes σ by least squares, then checks its three conditions.
      const Eigen::VectorXd pull = problem.space.transpose() * (problem.gradient + problem.hessian * step.d);
      const Eigen::VectorXd weight = problem.space.transpose() * problem.metric * step.d;
      const double shift = -pull.dot(weight) / weight.squaredNorm();
      EXPECT_LT((pull + shift * weight).norm(), 1e-6 * problem.gradient.norm()) << seed << " " << radius;
      EXPECT_GE(shift, 0);
      EXPECT_GT(problem.eigenvalues_in_space(problem.hessian + shift * problem.metric).minCoeff(), -1e-8);
    }
  }
}

TEST(LanczosTrustRegion, TakesTheNewtonStepOfAConvexQuadraticInsideTheBall) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Problem problem(seed, 30);
    ASSERT_GT(problem.eigenvalues_in_space(problem.hessian).minCoeff(), 0);
    const Eigen::MatrixXd reduced = test::reduced_to(problem.space, problem.hessian);
    const Eigen::VectorXd newton =
        -problem.space * test::solve(reduced, problem.space.transpose() * problem.gradient).col(0);
    const ModelStep step = problem.model(kUnknowns).step(1e3);
    EXPECT_TRUE(step.is_inside);
    // The iteration stops when the residual is a hundredth of the first residual. Then the quadratic (`problem.value`)
    // is near its minimum.
    EXPECT_NEAR(step.decrease, -problem.value(newton), 1e-2 * -problem.value(newton));
    EXPECT_LE(step.decrease, -problem.value(newton) * (1 + 1e-12));
  }
}

TEST(LanczosTrustRegion, FewVectorsDescendAndStayInTheBall) {
  const Problem problem(3, 0);
  double before = 0;
  for (int size = 1; size <= kUnknowns - kConstraints; ++size) {
    const LanczosTrustRegion model = problem.model(size);
    EXPECT_EQ(model.size(), size);
    const ModelStep step = model.step(0.7);
    EXPECT_LE(std::sqrt(step.d.dot(problem.metric * step.d)), 0.7 * (1 + 1e-9));
    EXPECT_GE(-problem.value(step.d), before * (1 - 1e-9)) << "a larger span contains a better step";
    before = -problem.value(step.d);
  }
}

TEST(LanczosTrustRegion, ConvexLengthIsTheLengthOfTheStepIfTheHessianIsTheMetric) {
  Problem problem(5, 0);
  problem.hessian = problem.metric;
  const LanczosTrustRegion model = problem.model(kUnknowns);
  EXPECT_EQ(model.size(), 1);
  const ModelStep step = model.step(1e3);
  EXPECT_NEAR(step.length, model.convex_length(), 1e-9 * step.length);
  EXPECT_NEAR(step.decrease, step.length * step.length / 2, 1e-9);
}

TEST(LanczosTrustRegion, RefusesAGradientWithNan) {
  Problem problem(1, 0);
  problem.gradient[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(problem.model(kUnknowns), FactorizationFailed);
}

}  // namespace
}  // namespace wirewarp::test_lanczos_trust_region
