// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the terms of the objective: shape error, bending and barriers.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "dense_algebra.h"
#include "energy/fair_shape_error.h"
#include "energy/log_barrier.h"
#include "energy/outline_barrier.h"
#include "energy/vertex_matrix.h"
#include "test_meshes.h"

namespace wirewarp::test_fair_shape_error {
namespace {

Positions2 random_positions(Eigen::Index rows, unsigned seed) { return test::random_normal(rows, 2, seed); }

double dot(const Positions2& a, const Positions2& b) { return (a.array() * b.array()).sum(); }

/// A bent sheet with crossing wires, and layouts with open, compressed, nearly collapsed and flipped triangles.
class FairShapeErrorOnASaddle : public testing::Test {
 protected:
  static FlattenInput input() {
    FlattenInput saddle = test::saddle(4, 0.4);
    test::add_wire(saddle, test::grid_row(4, 2));
    test::add_wire(saddle, test::grid_column(4, 4, 1), 0.05);
    return saddle;
  }

  Positions2 layout(unsigned seed) const {
    const Positions2 flat = test::planar_positions(chart);
    return 0.8 * flat + 0.15 * random_positions(flat.rows(), seed);
  }

  Eigen::MatrixXd hessian(const Positions2& uv, Curvature curvature) {
    std::vector<VertexPair> pairs;
    objective.list_pairs(pairs);
    VertexMatrix matrix(static_cast<int>(chart.mesh.n_vertices()), pairs);
    objective.attach_to(matrix);
    objective.add_constant_hessian(matrix);
    objective.add_curvature(uv, curvature, matrix);
    return test::symmetric(matrix.lower());
  }

  /// Compares gradient and Hessian with central differences along the line uv + t d.
  void expect_derivatives(const Positions2& uv, const Positions2& d, double hessian_tolerance) {
    // The error of a difference is h² times the third derivative plus rounding errors over h. If a triangle enters the
    // barrier, this error is h times the barrier's second derivative.
    const double h = 1e-6;
    Positions2 gradient, ahead, behind;
    EXPECT_DOUBLE_EQ(objective.value_and_gradient(uv, gradient), objective.value(uv));
    const double slope = (objective.value(uv + h * d) - objective.value(uv - h * d)) / (2 * h);
    EXPECT_NEAR(dot(gradient, d), slope, 1e-6 * gradient.norm() * d.norm());
    objective.value_and_gradient(uv + h * d, ahead);
    objective.value_and_gradient(uv - h * d, behind);
    const Eigen::VectorXd change = (ahead - behind).reshaped<Eigen::RowMajor>() / (2 * h);
    const Eigen::VectorXd expected = hessian(uv, Curvature::exact) * d.reshaped<Eigen::RowMajor>();
    EXPECT_LT((change - expected).norm(), hessian_tolerance * expected.norm());
  }

  const Chart chart = test::chart_of(input());
  const HeldNetwork network = build_held_network(chart);
  FairShapeError objective{chart, network, 0.2};
};

TEST_F(FairShapeErrorOnASaddle, DerivativesEqualDifferences) {
  bool is_barrier_met = false;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Positions2 uv = layout(seed);
    is_barrier_met = is_barrier_met || objective.count_flips(uv) > 0;
    expect_derivatives(uv, random_positions(uv.rows(), seed + 100), 1e-6);
  }
  EXPECT_TRUE(is_barrier_met);
}

TEST_F(FairShapeErrorOnASaddle, OtherCurvaturesBoundTheExactCurvatureAndTheConvexCurvatureIsPositive) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Positions2 uv = layout(seed);
    const Eigen::MatrixXd exact = hessian(uv, Curvature::exact), convex = hessian(uv, Curvature::convex),
                          none = hessian(uv, Curvature::none);
    const double rounding = 1e-12 * none.norm();
    EXPECT_LT(test::eigenvalues(exact).minCoeff(), -rounding) << "the exact Hessian needs no convex replacement";
    EXPECT_GT(test::eigenvalues(convex - exact).minCoeff(), -rounding);
    EXPECT_GT(test::eigenvalues(none - convex).minCoeff(), -rounding);
    EXPECT_GT(test::eigenvalues(convex).minCoeff(), -rounding);
  }
}

TEST_F(FairShapeErrorOnASaddle, RoundingCostsHalfTheTraceOfTheHessian) {
  const double error = 1e-3, trace = hessian(test::planar_positions(chart), Curvature::none).trace();
  const double expected = error * error / 2 * trace;
  EXPECT_NEAR(objective.value_of_rounding(error), expected, 1e-12 * expected);
}

TEST_F(FairShapeErrorOnASaddle, BarriersAreZeroForOpenTrianglesAndOnlyTheInfiniteBarrierForbidsFlips) {
  const FairShapeError injective(chart, network, 0.2, nullptr, Injectivity::local);
  const Positions2 flat = test::planar_positions(chart), turned = layout(1);
  ASSERT_GT(objective.count_flips(turned), 0);
  EXPECT_EQ(injective.value(flat), objective.value(flat));
  EXPECT_TRUE(std::isfinite(objective.value(turned)));
  EXPECT_EQ(injective.value(turned), std::numeric_limits<double>::infinity());
}

/// Triangles are squeezed to determinants from 0.01 to 0.09, where the infinite barrier is active.
TEST_F(FairShapeErrorOnASaddle, DerivativesOfTheInfiniteBarrierEqualDifferences) {
  objective = FairShapeError(chart, network, 0.2, nullptr, Injectivity::local);
  const Positions2 flat = test::planar_positions(chart);
  const Positions2 uv = flat * Eigen::Vector2d(1, 0.05).asDiagonal() + 1e-3 * random_positions(flat.rows(), 5);
  ASSERT_TRUE(std::isfinite(objective.value(uv)));
  expect_derivatives(uv, random_positions(flat.rows(), 6), 1e-4);
  const Eigen::MatrixXd convex = hessian(uv, Curvature::convex);
  EXPECT_GT(test::eigenvalues(convex).minCoeff(), -1e-12 * convex.norm());
}

/// The sheet of FairShapeErrorOnASaddle, made of a fabric whose threads lock. In its layouts, triangles are stretched
/// and squeezed, but not flipped.
class FairShapeErrorOfAFabric : public FairShapeErrorOnASaddle {
 protected:
  static Cloth locking_cloth() {
    Cloth cloth;
    cloth.weft = 0.3;
    cloth.shear = 0.05;
    cloth.squeeze = 2;
    cloth.locking = 0.1;
    return cloth;
  }

  Positions2 open_layout(unsigned seed) const {
    const Positions2 flat = test::planar_positions(chart);
    return flat + 0.04 * random_positions(flat.rows(), seed);
  }

  const Cloth cloth = locking_cloth();
  void SetUp() override { objective = FairShapeError(chart, network, 0.2, &cloth, Injectivity::local); }
};

TEST_F(FairShapeErrorOfAFabric, DerivativesEqualDifferences) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Positions2 uv = open_layout(seed);
    ASSERT_EQ(objective.count_flips(uv), 0);
    expect_derivatives(uv, random_positions(uv.rows(), seed + 100), 1e-5);
  }
}

TEST_F(FairShapeErrorOfAFabric, TheConvexCurvatureIsPositiveAndAboveTheExactCurvature) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Eigen::MatrixXd exact = hessian(open_layout(seed), Curvature::exact),
                          convex = hessian(open_layout(seed), Curvature::convex);
    const double rounding = 1e-12 * convex.norm();
    EXPECT_LT(test::eigenvalues(exact).minCoeff(), -rounding) << "the exact Hessian needs no convex replacement";
    EXPECT_GT(test::eigenvalues(convex).minCoeff(), -rounding);
    EXPECT_GT(test::eigenvalues(convex - exact).minCoeff(), -rounding);
  }
}

TEST(FairShapeError, AStepEndsWhereTheFirstTriangleFlips) {
  const Chart chart = test::chart_of(test::flat_rectangle(1, 1, 1, 1));  // diagonal from (0, 0) to (1, 1)
  const HeldNetwork network = build_held_network(chart);
  const Positions2 uv = test::planar_positions(chart);
  Positions2 d = Positions2::Zero(4, 2);
  d.row(1) << -1, 1;  // moves the corner (1, 0) onto the diagonal after half of the step
  const FairShapeError injective(chart, network, 0.1, nullptr, Injectivity::local);
  EXPECT_NEAR(injective.longest_step(uv, d), 0.5, 1e-15);
  EXPECT_EQ(injective.longest_step(uv, 0.4 * d), 1);
  EXPECT_EQ(injective.longest_step(uv, -d), 1);
  EXPECT_EQ(FairShapeError(chart, network, 0.1).longest_step(uv, d), 1) << "flips are not forbidden";
}

Bending bending(const Chart& chart, double fairness) {
  return bending_of(chart, build_held_network(chart), fairness, std::vector<double>(chart.mesh.n_vertices(), 1));
}

TEST(FairShapeError, AMirrorImageHasOnlyFlippedTriangles) {
  const Chart chart = test::chart_of(test::flat_rectangle(3, 2, 3, 2));
  const FairShapeError objective(chart, build_held_network(chart), 0.1);
  const Positions2 uv = test::planar_positions(chart);
  EXPECT_EQ(objective.count_flips(uv), 0);
  EXPECT_EQ(objective.count_flips(uv * Eigen::Vector2d(-1, 1).asDiagonal()), 12);
  EXPECT_NEAR(objective.value(uv), 0, 1e-25);
  EXPECT_NEAR(bending(chart, 0.1).value(uv), 0, 1e-25);
}

/// A square is sheared by β into a rhombus, with exact lengths along rows and columns. Every angle between a row and a
/// column changes by β, so the squared residual of this angle is 2 - 2 cos β.
TEST(BendingOfARhombus, IsTheAngleTermOfEquation1HoweverFineTheMesh) {
  for (const int n : {4, 64}) {
    FlattenInput input = test::flat_rectangle(n, n, 1, 1);
    test::add_wire(input, test::grid_row(n, n / 2));
    test::add_wire(input, test::grid_column(n, n, n / 2), 0.1);
    test::add_wire(input, test::grid_column(n, n, 1),
                   std::numeric_limits<double>::infinity());  // a free wire has no corners
    const Chart chart = test::chart_of(input);
    const double beta = 0.3, fairness = 0.25;
    Positions2 uv = test::planar_positions(chart);
    uv = (uv * (Eigen::Matrix2d() << 1, 0, std::sin(beta), std::cos(beta)).finished()).eval();
    const int of_square = 4, between_lines = 4 * 2 + 4;  // corners between wires and the outline, and at the crossing
    const double lengths = of_square * n + between_lines * std::min<double>(n, 8 / fairness);  // sum of 1/ℓ
    const double expected = 0.5 * lengths * std::pow(fairness, 3) * (2 - 2 * std::cos(beta));
    EXPECT_NEAR(bending(chart, fairness).value(uv), expected, 1e-13);
    const double moved = bending(chart, fairness).value(uv.rowwise() + Eigen::RowVector2d(1e6, -2e6));
    EXPECT_NEAR(moved, expected, 1e-7) << "only differences of positions matter";
  }
}

/// Two edges of a row are each rotated by γ about their common vertex.
TEST(BendingOfAFold, HasNoCornersAtTheEndsOfAWireInsideAndIsABendOfTheLineAtACrossing) {
  const int n = 4;
  const double gamma = 0.2;
  const auto value = [&](FlattenInput input, double fairness) {
    test::add_wire(input, test::section(test::grid_row(n, 2), 1, 3));
    const Chart chart = test::chart_of(input);
    Positions2 uv = test::planar_positions(chart);  // vertices have the order of the input
    const int middle = test::grid_row(n, 2)[2];
    uv.row(middle - 1) = uv.row(middle) + Eigen::RowVector2d(-std::cos(gamma), -std::sin(gamma)) / n;
    uv.row(middle + 1) = uv.row(middle) + Eigen::RowVector2d(std::cos(gamma), -std::sin(gamma)) / n;
    return bending(chart, fairness).value(uv);
  };
  const auto squared = [](double angle) { return 2 - 2 * std::cos(angle); };
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  EXPECT_NEAR(value(input, 0.1), 0.5 * 2 * std::pow(0.1, 3) * n * squared(2 * gamma), 1e-13);
  test::add_wire(input, test::grid_column(n, n, n / 2));
  EXPECT_NEAR(value(input, 0.1), 0.5 * 4 * std::pow(0.1, 3) * n * squared(gamma), 1e-13);
  // With much fairness, corners get only the weight of a coarse mesh, and the line gets the rest.
  const double fairness = 4, corner = std::pow(fairness, 3) * 8 / fairness, line = std::pow(fairness, 3) * n - corner;
  EXPECT_NEAR(value(input, fairness), 0.5 * (4 * corner * squared(gamma) + 2 * line / 2 * squared(2 * gamma)), 1e-10);
}

TEST(VertexMatrix, AVertexPairedWithItselfHasItsDiagonalBlockOnly) {
  const VertexMatrix matrix(3, {{0, 0}, {2, 0}, {1, 1}, {0, 0}}), without(3, {{2, 0}});
  EXPECT_EQ(matrix.lower().nonZeros(), without.lower().nonZeros());
  // Eigen copies a submatrix by columns, and requires sorted rows for this.
  EXPECT_EQ(Eigen::SparseMatrix<double>(matrix.lower().topLeftCorner(4, 4)).nonZeros(), 6);
}

constexpr double kGap = 0.02;

TEST(LogBarrier, HasTheValueAndDerivativesOfItsFormula) {
  const double x = 0.3, step = 1e-5;
  const auto b = [](double at) { return -(1 - at) * (1 - at) * std::log(at); };
  EXPECT_NEAR(LogBarrier(x).value, b(x), 1e-15);
  EXPECT_NEAR(LogBarrier(x).slope, (b(x + step) - b(x - step)) / (2 * step), 1e-7);
  EXPECT_NEAR(LogBarrier(x).curvature, (LogBarrier(x + step).slope - LogBarrier(x - step).slope) / (2 * step), 1e-7);
  EXPECT_EQ(LogBarrier(1).value, 0);
  EXPECT_EQ(LogBarrier(0).value, std::numeric_limits<double>::infinity());
}

/// A plate with a notch of width kGap. Edges are 1 long, and the barrier begins at distances of 0.1.
class OutlineOfANotch : public testing::Test {
 protected:
  /// Returns a U-shaped plate: 5 by 3 squares without the upper two squares in the middle.
  static FlattenInput plate() {
    return test::keep_faces(test::flat_rectangle(5, 3, 5, 3),
                            [](const Eigen::Vector3d& p) { return !(p.x() > 2 && p.x() < 3 && p.y() > 1); });
  }

  /// Returns the shape with the arms moved together until the notch has this width.
  Positions2 closed_to(double gap) const {
    Positions2 uv = wide;
    for (int v = 0; v < uv.rows(); ++v) {
      if (uv(v, 1) > 1.5) uv(v, 0) += (uv(v, 0) < 2.5 ? 1 : -1) * (1 - gap) / 2;
    }
    return uv;
  }

  const Chart chart = test::chart_of(plate());
  const Positions2 wide = test::planar_positions(chart);
  const Positions2 narrow = closed_to(kGap);
  const OutlineBarrier barrier{chart, narrow};
};

TEST_F(OutlineOfANotch, IsZeroForAWideNotchAndInfiniteIfTheOutlineTouches) {
  EXPECT_EQ(barrier.value(wide), 0);
  EXPECT_GT(barrier.value(narrow), 0);
  EXPECT_TRUE(std::isfinite(barrier.value(narrow)));
  EXPECT_EQ(barrier.value(closed_to(0)), std::numeric_limits<double>::infinity());
}

/// Every energy of a shape is proportional to the area. Otherwise the shape would depend on the unit of length.
TEST_F(OutlineOfANotch, IsProportionalToTheArea) {
  const double scale = 1024;
  FlattenInput large = plate();
  large.vertices *= scale;
  const Chart chart_of_large = test::chart_of(large);
  const double expected = scale * scale * barrier.value(narrow);
  EXPECT_NEAR(OutlineBarrier(chart_of_large, scale * narrow).value(scale * narrow), expected, 1e-12 * expected);
}

TEST_F(OutlineOfANotch, GradientEqualsDifferences) {
  Positions2 uv = narrow, gradient = Positions2::Zero(uv.rows(), 2);
  for (int v = 0; v < uv.rows(); ++v) uv.row(v) += 2e-3 * Eigen::RowVector2d(std::sin(3.0 * v), std::cos(5.0 * v));
  barrier.add_gradient(uv, gradient);
  const double step = 1e-7;
  for (int v = 0; v < uv.rows(); ++v) {
    for (int k = 0; k < 2; ++k) {
      Positions2 ahead = uv, behind = uv;
      ahead(v, k) += step;
      behind(v, k) -= step;
      EXPECT_NEAR(gradient(v, k), (barrier.value(ahead) - barrier.value(behind)) / (2 * step),
                  1e-5 * gradient.cwiseAbs().maxCoeff());
    }
  }
}

/// The arms move towards each other. All distances are linear in this motion, so the Gauss-Newton Hessian is exact.
TEST_F(OutlineOfANotch, HessianEqualsDifferencesAlongALinearMotion) {
  std::vector<VertexPair> pairs;
  barrier.list_pairs(pairs);
  VertexMatrix matrix(static_cast<int>(chart.mesh.n_vertices()), pairs);
  barrier.add_hessian(narrow, matrix);
  const Eigen::MatrixXd hessian = test::symmetric(matrix.lower());
  EXPECT_GT(test::eigenvalues(hessian).minCoeff(), -1e-12 * hessian.norm());
  const double step = 1e-5;
  const Positions2 closing = (closed_to(kGap - step) - narrow) / step;
  const double second =
      (barrier.value(closed_to(kGap - step)) - 2 * barrier.value(narrow) + barrier.value(closed_to(kGap + step))) /
      (step * step);
  const Eigen::VectorXd d = closing.reshaped<Eigen::RowMajor>();
  EXPECT_NEAR(d.dot(hessian * d), second, 1e-4 * second);
}

TEST_F(OutlineOfANotch, AStepEndsWhereTheOutlineFirstTouches) {
  // A quarter of this step of four gap widths closes the notch.
  const Positions2 too_far = closed_to(-3 * kGap) - narrow;
  EXPECT_NEAR(barrier.longest_step(narrow, too_far), 0.25, 1e-12);
  EXPECT_EQ(barrier.longest_step(narrow, wide - narrow), 1);
  EXPECT_EQ(barrier.longest_step(wide, closed_to(kGap) - wide), 1);
}

TEST_F(OutlineOfANotch, ReportsWhetherItsHessianHasAllContacts) {
  EXPECT_TRUE(barrier.covers_contacts(narrow));
  EXPECT_TRUE(barrier.covers_contacts(wide));
  EXPECT_FALSE(OutlineBarrier(chart, wide).covers_contacts(narrow));
}

}  // namespace
}  // namespace wirewarp::test_fair_shape_error
