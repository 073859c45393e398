// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "base/planar.h"
#include "dense_algebra.h"
#include "energy/free_boundary_arap.h"
#include "energy/shape_error.h"
#include "energy/tutte_embedding.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"

namespace wirewarp::test_free_boundary_arap {
namespace {

constexpr int kUntilConverged = 5000;

double largest_stretch(const Chart& chart, const Positions2& uv) {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * uv.cwiseAbs().maxCoeff();
  double largest = 0;
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    const int a = chart.mesh.from_vertex_handle(h).idx(), b = chart.mesh.to_vertex_handle(h).idx();
    const double length = edge_length(chart.mesh, h);
    largest = std::max(largest, (std::abs((uv.row(a) - uv.row(b)).norm() - length) - rounding) / length);
  }
  return largest;
}

FlattenInput rolled_plate_with_two_holes() {
  FlattenInput input = test::flat_plate_with_two_holes(8);
  for (Eigen::Index v = 0; v < input.vertices.rows(); ++v) {
    const Eigen::RowVector3d p = input.vertices.row(v);
    input.vertices.row(v) << std::sin(p.x()), p.y(), std::cos(p.x());
  }
  return input;
}

FlattenInput cut_square() {
  const int n = 8;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, test::section(test::grid_column(n, n, n / 2), 0, 3));
  test::add_seam(input, test::section(test::grid_row(n, 6), 2, 6));
  return input;
}

FlattenInput sliver_plate() {
  const int nx = 9;
  return test::make_grid(nx, 6, [](double s, double t) {
    const auto column = static_cast<int>(std::lround(nx * s)), pair = column / 2;
    return Eigen::Vector3d(pair / 4.0 + (column % 2) * 1e-6, t, 0);
  });
}

/// Returns a plate in which every triangle has an angle above 150 degrees, so that a third of the cotangents are
/// negative.
FlattenInput sheared_plate() {
  return test::make_grid(8, 8, [](double s, double t) { return Eigen::Vector3d(s - 3 * t, t, 0); });
}

TEST(CircleEmbedding, FlipsNoTriangle) {
  for (const auto& [name, input] : std::map<std::string, FlattenInput>{
           {"quarter sphere", test::quarter_sphere(8)},
           {"plate with holes", rolled_plate_with_two_holes()},
           {"darts", cut_square()},
           {"tube", test::cylinder_tube(24, 8, 1, 2)},
           {"strip", test::flat_rectangle(40, 1, 40, 1)},
           {"gore", test::sphere_of_gores(6, 3, 12)},
           {"slivers", sliver_plate()},
       }) {
    SCOPED_TRACE(name);
    const Chart chart = test::chart_of(input);
    const Positions2 uv = tutte_embedding(chart);
    EXPECT_EQ(ShapeError(chart).count_flips(uv), 0);
    for (const HalfedgeHandle h : chart.boundary_loops.front()) {
      const double r = uv.row(chart.mesh.from_vertex_handle(h).idx()).norm();
      EXPECT_NEAR(r * r * kPi, surface_area(chart.mesh), 1e-12 * surface_area(chart.mesh));
    }
  }
}

/// Near E = 0, every step lowers E by a constant factor, so the iteration continues down to rounding errors.
TEST(FreeArap, KeepsTheLengthsOfDevelopableCharts) {
  for (const auto& [name, input] : std::map<std::string, FlattenInput>{
           {"cylinder", test::cylinder_patch(16, 12, 1, 2.5, 1.5)},
           {"cone", test::cone_patch(16, 12, 1, 3, 0.5, 4)},
           {"plate with holes", rolled_plate_with_two_holes()},
           {"darts", cut_square()},
           {"strip", test::flat_rectangle(12, 1, 12, 1)},
           {"slivers", sliver_plate()},
           {"negative cotangents", sheared_plate()},
       }) {
    SCOPED_TRACE(name);
    const Chart chart = test::chart_of(input);
    const FreeBoundaryArap flat = free_boundary_arap(chart, kUntilConverged);
    EXPECT_TRUE(flat.converged);
    EXPECT_LT(largest_stretch(chart, flat.uv), 1e-13);
    EXPECT_EQ(ShapeError(chart).count_flips(flat.uv), 0);
  }
}

TEST(FreeArap, ReachesTheKnownEnergyOfTheQuarterSphere) {
  const Chart chart = test::chart_of(test::quarter_sphere(16));
  const FreeBoundaryArap flat = free_boundary_arap(chart, kUntilConverged);
  EXPECT_TRUE(flat.converged);
  EXPECT_EQ(flat.factorizations, 2);
  EXPECT_LE(flat.iterations, 10);
  const double expected = 0.00421971;  // computed by an independent program
  EXPECT_NEAR(flat.energy / surface_area(chart.mesh), expected, 0.01 * expected);
  EXPECT_EQ(ShapeError(chart).energy(flat.uv), flat.energy);
}

TEST(FreeArap, StopsAtAnyStepWhenAsked) {
  const Chart chart = test::chart_of(test::quarter_sphere(16));
  for (int steps = 0; steps < 4; ++steps) {
    int asked = 0;
    const StopToken stop([&](const char*) { return asked++ < steps; });
    EXPECT_THROW(free_boundary_arap(chart, kUntilConverged, {}, stop), Stopped);
    EXPECT_EQ(asked, steps + 1);
  }
}

/// Bending a long strip as a whole costs almost no energy, so independent steps hardly bend it, but conjugate steps do.
TEST(FreeArap, UnrollsALongStripByConjugateSteps) {
  const Chart chart = test::chart_of(test::cone_patch(48, 4, 10, 11, 0.5, 4));
  Positions2 uv = tutte_embedding(chart);
  for (int step = 0; step < 100; ++step) uv = free_boundary_arap(chart, 1, uv).uv;
  EXPECT_LT(free_boundary_arap(chart, 30).energy, ShapeError(chart).energy(uv));
}

class FreeArapOnASphere : public testing::Test {
 protected:
  Positions2 random_positions(unsigned seed) const { return test::random_normal(chart.mesh.n_vertices(), 2, seed); }

  const Chart chart = test::chart_of(test::quarter_sphere(6));
  const ShapeError shape_error{chart};
};

TEST_F(FreeArapOnASphere, NeverRaisesTheEnergy) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    // Half of the triangles are flipped at the start, so the first steps are large.
    const Positions2 start = random_positions(seed);
    double energy = free_boundary_arap(chart, 0, start).energy;
    for (int steps = 1; steps <= 30; ++steps) {
      const FreeBoundaryArap flat = free_boundary_arap(chart, steps, start);
      EXPECT_LE(flat.energy, energy);
      EXPECT_TRUE(flat.iterations == steps || flat.converged);
      EXPECT_EQ(flat.factorizations, 1);
      energy = flat.energy;
    }
  }
}

TEST_F(FreeArapOnASphere, StartsFromTheEmbeddingOnACircle) {
  const FreeBoundaryArap flat = free_boundary_arap(chart, 0);
  EXPECT_EQ(flat.uv, tutte_embedding(chart));
  EXPECT_FALSE(flat.converged);
  EXPECT_EQ(free_boundary_arap(chart, 10).uv, free_boundary_arap(chart, 10, flat.uv).uv);
}

TEST_F(FreeArapOnASphere, FlipsAMirroredStart) {
  const Positions2 start = tutte_embedding(chart);
  const Positions2 mirrored = start * Eigen::Vector2d(-1, 1).asDiagonal();
  EXPECT_EQ(free_boundary_arap(chart, 10, mirrored).uv, free_boundary_arap(chart, 10, start).uv);
}

TEST_F(FreeArapOnASphere, GradientEqualsDifferences) {
  // The error of fourth-order differences is h⁴ times the fifth derivative plus rounding errors over h.
  const double h = 1e-3;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Positions2 uv = random_positions(seed), direction = random_positions(seed + 100);
    const auto energy = [&](double t) { return shape_error.energy(uv + t * direction); };
    const double difference = (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
    Positions2 gradient;
    EXPECT_EQ(shape_error.energy_and_gradient(uv, gradient), energy(0));
    EXPECT_NEAR((gradient.array() * direction.array()).sum(), difference, 1e-8 * gradient.norm() * direction.norm());
  }
}

TEST_F(FreeArapOnASphere, FixedRotationsBoundTheEnergy) {
  const Eigen::SparseMatrix<double> hessian = shape_error.fixed_rotation_hessian();
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Positions2 uv = random_positions(seed), step = random_positions(seed + 100);
    Positions2 gradient;
    const double energy = shape_error.energy_and_gradient(uv, gradient);
    const Positions2 curved = hessian.selfadjointView<Eigen::Lower>() * step;
    const double slope = (gradient.array() * step.array()).sum(), curvature = (curved.array() * step.array()).sum();
    EXPECT_LE(shape_error.energy(uv + step), energy + slope + curvature / 2);
    // A step that shrinks the layout changes no rotation, so the bound is exact.
    Positions2 inwards = -0.3 * uv;
    const double shrunk = shape_error.energy(uv + inwards);
    const Positions2 pulled = hessian.selfadjointView<Eigen::Lower>() * inwards;
    EXPECT_NEAR(energy + (gradient.array() * inwards.array()).sum() + (pulled.array() * inwards.array()).sum() / 2,
                shrunk, 1e-12 * energy);
  }
}

/// For a uniform stretch s, E = 2A (s - 1)². In the mirror image, the similarity part z of the map is 0, and its
/// reflection part w has |w| = s.
TEST(ShapeError, CountsMirrorImagesAgainstRotations) {
  const Chart chart = test::chart_of(test::flat_rectangle(3, 2, 3, 2));
  const ShapeError shape_error(chart);
  const Positions2 uv = test::planar_positions(chart);
  const double area = 6, s = 1.5;
  EXPECT_NEAR(shape_error.energy(s * uv), area * 2 * (s - 1) * (s - 1), 1e-12);
  const Positions2 mirrored = s * uv * Eigen::Vector2d(-1, 1).asDiagonal();
  EXPECT_NEAR(shape_error.energy(mirrored), area * (2 + 2 * s * s), 1e-12);
}

/// If the similarity part z of a map is 0, the gradient is that of A (2 + 2|w|²), with the area A and the reflection
/// part w. It must be finite, without a division by zero.
TEST(ShapeError, HasAFiniteGradientIfNoRotationIsBest) {
  const Chart chart = test::chart_of(test::flat_rectangle(3, 2, 3, 2));
  const ShapeError shape_error(chart);
  Positions2 gradient;
  EXPECT_NEAR(shape_error.energy_and_gradient(Positions2::Constant(12, 2, 0.7), gradient), 6 * 2, 1e-13);
  EXPECT_EQ(gradient, Positions2::Zero(12, 2));

  const Positions2 mirrored = test::planar_positions(chart) * Eigen::Vector2d(-1, 1).asDiagonal();
  shape_error.energy_and_gradient(mirrored, gradient);
  // For a stretch by s, d/ds A(2 + 2s²) = 4A at s = 1.
  EXPECT_NEAR((gradient.array() * mirrored.array()).sum(), 4 * 6, 1e-11);
}

}  // namespace
}  // namespace wirewarp::test_free_boundary_arap
