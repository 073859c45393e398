// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dense_algebra.h"
#include "energy/shear_smoothing.h"
#include "newton/unfold.h"
#include "test_meshes.h"

namespace wirewarp::test_shear_smoothing {
namespace {

/// Unit square of two triangles that share the diagonal: l = √2, the centroids √2/3 apart.
TEST(ShearSmoothing, AFoldCostsTheSquareOfItsAngle) {
  const Charts charts = test::charts_of(test::flat_rectangle(1, 1, 1, 1));  // cut from (0, 0) to (1, 1)
  const Chart& chart = charts.charts.at(0);
  const double slope = 0.3, height = std::sqrt(0.5);
  Positions2 uv = test::planar_positions(chart);
  uv(1, 0) += slope * height;  // the corner (1, 0)
  const double delta = 0.005, l_over_d = 3;
  const double expected = 0.5 * delta * delta * l_over_d * slope * slope;
  EXPECT_NEAR(ShearSmoothing(chart).value(uv), expected, 1e-14 * expected);
}

TEST(ShearSmoothing, AnUnfoldedPieceCostsNothing) {
  const Charts charts = test::charts_of(test::cylinder_patch(7, 5, 1, 2, 1.5));
  const Chart& chart = charts.charts.at(0);
  EXPECT_LT(ShearSmoothing(chart).value(unfold(chart).value()), 1e-28);
}

TEST(ShearSmoothing, GradientAndHessianAreThoseOfAQuadraticFunction) {
  const Charts charts = test::charts_of(test::saddle(4, 0.4));
  const Chart& chart = charts.charts.at(0);
  const ShearSmoothing smoothing(chart);
  Positions2 uv = test::planar_positions(chart);
  for (int v = 0; v < uv.rows(); ++v) uv.row(v) += 0.1 * Eigen::RowVector2d(std::sin(7 * v), std::cos(5 * v));
  Positions2 gradient = Positions2::Zero(uv.rows(), 2);
  const double value = smoothing.add_gradient(uv, gradient);
  EXPECT_EQ(value, smoothing.value(uv));
  EXPECT_NEAR((gradient.array() * uv.array()).sum() / 2, value, 1e-13 * value);

  std::vector<VertexPair> pairs;
  smoothing.list_pairs(pairs);
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    pairs.push_back({chart.mesh.from_vertex_handle(h).idx(), chart.mesh.to_vertex_handle(h).idx()});
  }
  VertexMatrix matrix(static_cast<int>(uv.rows()), pairs);
  smoothing.add_hessian(matrix);
  const Eigen::MatrixXd hessian = Eigen::MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd product = hessian * uv.reshaped<Eigen::RowMajor>();
  EXPECT_LT((product - gradient.reshaped<Eigen::RowMajor>()).norm(), 1e-13 * product.norm());
  EXPECT_NEAR(smoothing.value_of_rounding(0.1), 0.01 * hessian.trace() / 2, 1e-12 * hessian.trace());
}

}  // namespace
}  // namespace wirewarp::test_shear_smoothing
