// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the barrier that prevents an outline from crossing itself, on a plate with a notch. The notch is 0.02 wide,
// edges are 1 long, and the barrier begins at distances of 0.1.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "dense_algebra.h"
#include "energy/log_barrier.h"
#include "energy/outline_barrier.h"
#include "test_meshes.h"

namespace wirewarp::test_outline_barrier {
namespace {

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

class OutlineOfANotch : public testing::Test {
 protected:
  /// Returns a U, which is a plate of 5 by 3 without the upper two squares in the middle.
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
  const OutlineBarrier barrier_of_large(chart_of_large, scale * narrow);
  EXPECT_NEAR(barrier_of_large.value(scale * narrow), scale * scale * barrier.value(narrow),
              1e-12 * scale * scale * barrier.value(narrow));
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
  const Eigen::MatrixXd hessian = Eigen::MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>();
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
}  // namespace wirewarp::test_outline_barrier
