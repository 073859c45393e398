// SPDX-License-Identifier: GPL-3.0-or-later
// Compares length constraints and the linear system of a Newton step with dense algebra.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "dense_algebra.h"
#include "energy/free_boundary_arap.h"
#include "newton/minimize.h"
#include "newton/newton_system.h"
#include "newton/retract_to_lengths.h"
#include "test_meshes.h"

namespace wirewarp::test_newton_system {
namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

Eigen::VectorXd random_vector(Eigen::Index size, unsigned seed) { return test::random_normal(size, 1, seed); }

Positions2 as_positions(const Eigen::VectorXd& v) { return Eigen::Map<const Positions2>(v.data(), v.size() / 2, 2); }

Eigen::VectorXd as_vector(const Positions2& p) { return Eigen::Map<const Eigen::VectorXd>(p.data(), p.size()); }

class NewtonSystemOnASaddle : public testing::Test {
 protected:
  static FlattenInput input() {
    const int n = 6;
    FlattenInput saddle = test::saddle(n, 0.3);
    test::add_wire(saddle, test::grid_row(n, 2));
    test::add_wire(saddle, test::grid_column(n, n, 2), 0.05);
    test::add_wire(saddle, test::grid_row(n, 4), kFree);
    test::add_wire(saddle, test::grid_column(n, n, 4), 0.1);
    return saddle;
  }

  Eigen::MatrixXd jacobian(const Positions2& directions) const {
    Eigen::MatrixXd j(constraints.size(), num_unknowns);
    for (int k = 0; k < num_unknowns; ++k) {
      j.col(k) = constraints.apply(directions, as_positions(Eigen::VectorXd::Unit(num_unknowns, k)));
    }
    return j;
  }

  /// Returns the lowest eigenvalue of the Hessian H on the null space of J, the Jacobian of the constraints.
  double lowest_curvature(const Eigen::VectorXd& multipliers, const Convexity& convexity) {
    const Eigen::MatrixXd space = test::null_space(jacobian(constraints.directions(uv)));
    return test::eigenvalues(test::reduced_to(space, test::symmetric(system.hessian(uv, multipliers, convexity))))[0];
  }

  const Chart chart = test::chart_of(input());
  const HeldNetwork network = build_held_network(chart);
  const LengthConstraints constraints{chart, network};
  FairShapeError objective{chart, network, 0.1};
  const Positions2 uv = free_boundary_arap(chart, 30).uv;
  NewtonSystem system{chart, objective, constraints, uv};
  const int num_unknowns = static_cast<int>(uv.size());
  const Convexity convex{Curvature::convex, false}, exact{Curvature::exact, true};
};

TEST_F(NewtonSystemOnASaddle, TheJacobianEqualsDifferences) {
  const double step = 1e-6;
  const Eigen::VectorXd h = 0.01 * random_vector(constraints.num_elastic(), 1);
  const Positions2 bent = uv + 0.05 * as_positions(random_vector(num_unknowns, 2));
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Positions2 d = as_positions(random_vector(num_unknowns, seed + 10));
    const Eigen::VectorXd dh = random_vector(constraints.num_elastic(), seed + 20);
    const Eigen::VectorXd difference =
        (constraints.residual(bent + step * d, h + step * dh) - constraints.residual(bent - step * d, h - step * dh)) /
        (2 * step);
    const Positions2 directions = constraints.directions(bent);
    EXPECT_LT((constraints.apply(directions, d) - constraints.elastic_lengths() * dh - difference).norm(), 1e-8);
    // The transposed product must use the same Jacobian.
    const Eigen::VectorXd multipliers = random_vector(constraints.size(), seed + 30);
    Positions2 pulled = Positions2::Zero(uv.rows(), 2);
    constraints.add_transposed(directions, multipliers, pulled);
    EXPECT_NEAR(as_vector(pulled).dot(as_vector(d)), multipliers.dot(constraints.apply(directions, d)), 1e-10);
  }
}

TEST_F(NewtonSystemOnASaddle, SolvesTheSystemOfTheNewtonStep) {
  const Eigen::VectorXd multipliers = 0.01 * random_vector(constraints.size(), 5);
  ASSERT_TRUE(system.factorize(uv, multipliers, convex));
  const Positions2 r1 = as_positions(random_vector(num_unknowns, 6));
  const Eigen::VectorXd r2 = random_vector(constraints.size(), 7);
  const NewtonSystem::Solution solution = system.solve_on_wires(r1, r2);
  const Positions2 d = system.finish(solution.d);
  const Positions2 directions = system.directions();
  EXPECT_LT((constraints.apply(directions, d) - r2).norm(), 1e-9 * r2.norm());
  const Eigen::SparseMatrix<double> h = system.hessian(uv, multipliers, convex);
  Positions2 forces = as_positions(h.selfadjointView<Eigen::Lower>() * as_vector(d)) - r1;
  constraints.add_transposed(directions, solution.multipliers, forces);
  EXPECT_LT(forces.norm(), 1e-6 * r1.norm());
  // least_change() returns the d with the least energy among all d with the same J d.
  const Positions2 least = system.finish(system.least_change(r2));
  EXPECT_LT((constraints.apply(directions, least) - r2).norm(), 1e-4 * r2.norm());
  const Positions2 unforced = system.finish(system.solve_on_wires(Positions2::Zero(uv.rows(), 2), r2).d);
  EXPECT_LT((least - unforced).norm(), 1e-4 * unforced.norm());
}

TEST_F(NewtonSystemOnASaddle, SolvesForLengthVariationsAfterEliminatingD) {
  ASSERT_TRUE(system.factorize(uv, 0.01 * random_vector(constraints.size(), 5), convex));
  const Positions2 r1 = as_positions(random_vector(num_unknowns, 6));
  const Eigen::VectorXd r2 = random_vector(constraints.size(), 7), h = random_vector(constraints.num_elastic(), 8);
  const Eigen::VectorXd stretched = r2 + constraints.elastic_lengths() * h;
  const NewtonSystem::Reduced reduced = system.reduce(r1, r2);
  const Eigen::VectorXd pull = constraints.elastic_lengths().transpose() * system.solve_on_wires(r1, r2).multipliers;
  EXPECT_LT((reduced.pull - pull).norm(), 1e-5 * pull.norm());
  const NewtonSystem::Solution expected = system.solve_on_wires(r1, stretched);
  const NewtonSystem::Solution solution = system.solve_on_wires(reduced, h);
  EXPECT_LT((solution.multipliers - expected.multipliers).norm(), 1e-7 * expected.multipliers.norm());
  const Positions2 d = system.finish(expected.d);
  EXPECT_LT((system.finish(solution.d) - d).norm(), 1e-7 * d.norm());
  const NewtonSystem::Solution rough = system.solve_roughly(reduced, h);
  EXPECT_LT((as_positions(rough.d).topRows(uv.rows()) - d).norm(), 1e-4 * d.norm());
}

TEST_F(NewtonSystemOnASaddle, FactorizesIfAndOnlyIfTheReducedHessianIsPositive) {
  const Eigen::VectorXd shape = random_vector(constraints.size(), 9);
  int positive = 0, negative = 0;
  for (const double size : {0.0, 1e-4, 1e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0}) {
    for (const Convexity& convexity :
         {convex, exact, Convexity{Curvature::convex, true}, Convexity{Curvature::exact, false}}) {
      const Eigen::VectorXd multipliers = size * shape;
      const double lowest = lowest_curvature(multipliers, convexity);
      if (std::abs(lowest) < 1e-5) continue;  // rounding errors of the large stiffness may change the sign
      const bool is_positive = system.factorize(uv, multipliers, convexity);
      EXPECT_EQ(is_positive, lowest > 0) << size << " " << lowest;
      ++(is_positive ? positive : negative);
    }
  }
  EXPECT_GT(positive, 5);
  EXPECT_GT(negative, 5);
}

TEST_F(NewtonSystemOnASaddle, TheHessianByVariationEqualsTheDenseHessian) {
  const Eigen::VectorXd multipliers = 0.01 * random_vector(constraints.size(), 5);
  ASSERT_TRUE(system.factorize(uv, multipliers, convex));
  const Eigen::MatrixXd j = jacobian(system.directions());
  const Eigen::MatrixXd h = test::symmetric(system.hessian(uv, multipliers, convex));
  // With S = Tᵀ (J H⁻¹ Jᵀ)⁻¹ T, the minimum of ½ d·Hd over all d with J d = T h is ½ h·S h. The pins make H regular.
  const Eigen::MatrixXd t = constraints.elastic_lengths();
  const Eigen::MatrixXd by_force = test::product(j, test::solve(h, j.transpose()));
  const Eigen::MatrixXd expected = test::product(t.transpose(), test::solve(by_force, t));
  EXPECT_LT((system.stiffness_by_variation() - expected).norm(), 1e-5 * expected.norm());
}

TEST_F(NewtonSystemOnASaddle, TheStiffnessByVariationEqualsTheDenseStiffness) {
  const Eigen::VectorXd soft = Eigen::VectorXd::LinSpaced(constraints.size(), 1, 2);
  system.set_stiffness(soft);
  ASSERT_TRUE(system.factorize(uv, 0 * soft, convex));
  const Eigen::MatrixXd j = jacobian(system.directions());
  const Eigen::MatrixXd stretched = soft.asDiagonal() * constraints.elastic_lengths();
  const Eigen::MatrixXd a =
      test::symmetric(system.hessian(uv, 0 * soft, convex)) + test::product(j.transpose(), soft.asDiagonal() * j);
  const Eigen::MatrixXd pulled = test::product(j.transpose(), stretched);
  // With the stiffness ρ of each edge, the minimum over d of ½ Σ ρ (J d − T h)² + ½ d·Hd is ½ h·S h.
  const Eigen::MatrixXd expected =
      constraints.elastic_lengths().transpose() * stretched - test::product(pulled.transpose(), test::solve(a, pulled));
  EXPECT_LT((system.stiffness_by_variation() - expected).norm(), 1e-9 * expected.norm());
}

TEST(MakePositive, DoesNotChangeNearlySingularPositiveMatrices) {
  const Eigen::MatrixXd positive = (Eigen::Matrix2d() << 1, 1, 1, 1 + 1e-5).finished();  // pivots 1 and 1e-5
  EXPECT_LT((make_positive(positive) - positive).norm(), 1e-14);
}

TEST(MakePositive, ReplacesEigenvaluesByTheirMagnitudes) {
  const Eigen::Matrix2d q = test::orthonormal(as_positions(random_vector(4, 1)));
  const Eigen::MatrixXd symmetric = q * Eigen::Vector2d(-3, 1e-9).asDiagonal() * q.transpose();
  const Eigen::MatrixXd expected = q * Eigen::Vector2d(3, 3e-6).asDiagonal() * q.transpose();
  EXPECT_LT((make_positive(symmetric) - expected).norm(), 1e-12);
}

TEST_F(NewtonSystemOnASaddle, TheRetractionSucceedsFromNearbyAndFailsFromFarAway) {
  ASSERT_TRUE(system.factorize(uv, Eigen::VectorXd::Zero(constraints.size()), Convexity{Curvature::none, false}));
  const Eigen::Vector2d h(0.01, -0.02);
  const Positions2 noise = as_positions(random_vector(num_unknowns, 3));
  Positions2 near = uv + 1e-3 * noise;
  EXPECT_TRUE(retract_to_lengths(constraints, system, h, near));
  EXPECT_LT(constraints.largest_error(constraints.residual(near, h)), 1e-12);
  Positions2 far = uv + 2 * noise;
  EXPECT_FALSE(retract_to_lengths(constraints, system, h, far));
}

TEST_F(NewtonSystemOnASaddle, TheRetractionStopsWhenTheCallerCancels) {
  ASSERT_TRUE(system.factorize(uv, Eigen::VectorXd::Zero(constraints.size()), Convexity{Curvature::none, false}));
  const Eigen::Vector2d h(0.01, -0.02);
  const Positions2 begin = uv + 0.02 * as_positions(random_vector(num_unknowns, 3));
  Positions2 slow = begin;
  int questions = 0;
  EXPECT_FALSE(
      retract_to_lengths(constraints, system, h, slow, StopToken([&](const char*) { return ++questions < 1; })));
  EXPECT_EQ(questions, 1);
  EXPECT_EQ(slow, begin);
  EXPECT_TRUE(retract_to_lengths(constraints, system, h, slow));
}

}  // namespace
}  // namespace wirewarp::test_newton_system
