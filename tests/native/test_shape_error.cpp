// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "energy/shape_error.h"
#include "test_meshes.h"

namespace wirewarp::test_shape_error {
namespace {

Positions2 random_positions(const Chart& chart, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Positions2 uv(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  for (double& x : uv.reshaped()) x = normal(random);
  return uv;
}

Positions2 turned(const Positions2& uv, double angle) {
  return uv * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
}

/// A curved chart and layouts of it with many flipped triangles.
class ShapeErrorOnASphere : public testing::Test {
 protected:
  const Charts charts = test::charts_of(test::quarter_sphere(6));
  const Chart& chart = charts.charts.at(0);
  const ShapeError shape_error{chart};
};

TEST_F(ShapeErrorOnASphere, GradientEqualsDifferences) {
  // Fourth-order differences: an error of h⁴ times the fifth derivative, and of rounding over h.
  const double h = 1e-3;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Positions2 uv = random_positions(chart, seed), direction = random_positions(chart, seed + 100);
    const auto energy = [&](double t) { return shape_error.energy(uv + t * direction); };
    const double difference = (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
    Positions2 gradient;
    EXPECT_EQ(shape_error.energy_and_gradient(uv, gradient), energy(0));
    EXPECT_NEAR((gradient.array() * direction.array()).sum(), difference, 1e-8 * gradient.norm() * direction.norm());
  }
}

TEST_F(ShapeErrorOnASphere, MotionsOfThePlaneChangeNothing) {
  const Positions2 uv = random_positions(chart, 1);
  const Positions2 moved = turned(uv, 0.8).rowwise() + Eigen::RowVector2d(3, -2);
  Positions2 gradient, moved_gradient;
  const double energy = shape_error.energy_and_gradient(uv, gradient);
  EXPECT_NEAR(shape_error.energy_and_gradient(moved, moved_gradient), energy, 1e-12 * energy);
  EXPECT_LT((moved_gradient - turned(gradient, 0.8)).norm(), 1e-12 * gradient.norm());
  // So the gradient neither pushes nor turns the whole.
  EXPECT_LT(gradient.colwise().sum().norm(), 1e-13 * gradient.norm() * std::sqrt(gradient.rows()));
  const double torque =
      (uv.col(0).array() * gradient.col(1).array() - uv.col(1).array() * gradient.col(0).array()).sum();
  EXPECT_LT(std::abs(torque), 1e-13 * uv.norm() * gradient.norm());
}

TEST_F(ShapeErrorOnASphere, HeldRotationsBoundTheEnergy) {
  const Eigen::SparseMatrix<double> hessian = shape_error.fixed_rotation_hessian();
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Positions2 uv = random_positions(chart, seed), step = random_positions(chart, seed + 100);
    Positions2 gradient;
    const double energy = shape_error.energy_and_gradient(uv, gradient);
    const Positions2 curved = hessian.selfadjointView<Eigen::Lower>() * step;
    const double slope = (gradient.array() * step.array()).sum(), curvature = (curved.array() * step.array()).sum();
    EXPECT_LE(shape_error.energy(uv + step), energy + slope + curvature / 2);
    // Toward a point no rotation changes: the bound is met.
    Positions2 inwards = -0.3 * uv;
    const double shrunk = shape_error.energy(uv + inwards);
    const Positions2 pulled = hessian.selfadjointView<Eigen::Lower>() * inwards;
    EXPECT_NEAR(energy + (gradient.array() * inwards.array()).sum() + (pulled.array() * inwards.array()).sum() / 2,
                shrunk, 1e-12 * energy);
  }
}

TEST(ShapeError, IsZeroOnTheDevelopmentOfACylinder) {
  const int nx = 6, ny = 4;
  const double radius = 2, angle = 1.5, height = 3;
  const Charts charts = test::charts_of(test::cylinder_patch(nx, ny, radius, angle, height));
  const Chart& chart = charts.charts.at(0);
  const double chord = 2 * radius * std::sin(angle / nx / 2);  // the mesh is a prism of flat strips
  Positions2 uv((nx + 1) * (ny + 1), 2);
  for (int v = 0; v < uv.rows(); ++v) {
    const int vertex = chart.source_vertex[static_cast<std::size_t>(v)];
    const int row = vertex / (nx + 1);
    uv.row(v) << chord * (vertex % (nx + 1)), height * row / ny;
  }
  Positions2 gradient;
  EXPECT_LT(ShapeError(chart).energy_and_gradient(turned(uv, 2), gradient), 1e-28);
  EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-13);
}

/// Without distortion but for a uniform stretch s, E = 2A (s - 1)²; in the mirror image |z| = 0 and |w| = s.
TEST(ShapeError, CountsMirrorImagesAgainstRotations) {
  const Charts charts = test::charts_of(test::flat_rectangle(3, 2, 3, 2));
  const Chart& chart = charts.charts.at(0);
  const ShapeError shape_error(chart);
  const Positions2 uv = test::planar_positions(chart);
  const double area = 6, s = 1.5;
  EXPECT_NEAR(shape_error.energy(s * uv), area * 2 * (s - 1) * (s - 1), 1e-12);
  const Positions2 mirrored = s * uv * Eigen::Vector2d(-1, 1).asDiagonal();
  EXPECT_NEAR(shape_error.energy(mirrored), area * (2 + 2 * s * s), 1e-12);
}

/// At z = 0 the gradient is that of A(2 + 2|w|²): finite, and with nothing to divide by.
TEST(ShapeError, HasAFiniteGradientWhereNoRotationIsBest) {
  const Charts charts = test::charts_of(test::flat_rectangle(3, 2, 3, 2));
  const Chart& chart = charts.charts.at(0);
  const ShapeError shape_error(chart);
  Positions2 gradient;
  EXPECT_NEAR(shape_error.energy_and_gradient(Positions2::Constant(12, 2, 0.7), gradient), 6 * 2, 1e-13);
  EXPECT_EQ(gradient, Positions2::Zero(12, 2));

  const Positions2 mirrored = test::planar_positions(chart) * Eigen::Vector2d(-1, 1).asDiagonal();
  shape_error.energy_and_gradient(mirrored, gradient);
  // Along the stretch by s, d/ds A(2 + 2s²) = 4A at s = 1.
  EXPECT_NEAR((gradient.array() * mirrored.array()).sum(), 4 * 6, 1e-11);
}

}  // namespace
}  // namespace wirewarp::test_shape_error
