// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "base/planar.h"
#include "energy/free_boundary_arap.h"
#include "energy/shape_error.h"
#include "energy/tutte_embedding.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"

namespace wirewarp::test_free_boundary_arap {
namespace {

constexpr int kUntilConverged = 5000;

/// All triangles in one point have E = 2A.
double area_3d(const Chart& chart) {
  return ShapeError(chart).energy(Positions2::Zero(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2)) / 2;
}

double smallest_area(const Chart& chart, const Positions2& uv) {
  double smallest = 1e300;
  for (const FaceHandle face : chart.mesh.faces()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(face);
    const auto at = [&](VertexHandle v) { return Eigen::Vector2d(uv.row(v.idx())); };
    const Eigen::Vector2d a = at(chart.mesh.from_vertex_handle(h)), b = at(chart.mesh.to_vertex_handle(h));
    const Eigen::Vector2d c = at(chart.mesh.to_vertex_handle(chart.mesh.next_halfedge_handle(h)));
    smallest = std::min(smallest, 0.5 * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()));
  }
  return smallest;
}

/// Largest change of an edge's length over the length, beyond what the rounding of coordinates makes of it.
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

/// Moves a by the rotation and shift that fit b best.
Positions2 moved_onto(const Positions2& a, const Positions2& b) {
  const Eigen::RowVector2d center_a = a.colwise().mean(), center_b = b.colwise().mean();
  const Positions2 from = a.rowwise() - center_a, to = b.rowwise() - center_b;
  const double cosine = (from.array() * to.array()).sum();
  const double sine = from.col(0).dot(to.col(1)) - from.col(1).dot(to.col(0));
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(std::atan2(sine, cosine)).toRotationMatrix();
  return (from * turn.transpose()).rowwise() + center_b;
}

/// A plate with two holes, rolled onto a cylinder of radius 1.
FlattenInput rolled_plate_with_two_holes() {
  FlattenInput input = test::flat_plate_with_two_holes(8);
  for (Eigen::Index v = 0; v < input.vertices.rows(); ++v) {
    const Eigen::RowVector3d p = input.vertices.row(v);
    input.vertices.row(v) << std::sin(p.x()), p.y(), std::cos(p.x());
  }
  return input;
}

/// A square cut from the middle of its lower side to its center, and once more inside.
FlattenInput cut_square() {
  const int n = 8;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  const auto column = test::grid_column(n, n, n / 2);
  test::add_seam(input, {column.begin(), column.begin() + 4});
  const auto row = test::grid_row(n, 6);
  test::add_seam(input, {row.begin() + 2, row.begin() + 7});
  return input;
}

/// Columns in pairs, 1e-6 apart.
FlattenInput sliver_plate() {
  const int nx = 9;
  return test::make_grid(nx, 6, [](double s, double t) {
    const auto column = static_cast<int>(std::lround(nx * s));
    const int pair = column / 2;
    return Eigen::Vector3d(pair / 4.0 + (column % 2) * 1e-6, t, 0);
  });
}

/// Every triangle has an angle above 150 degrees: a third of the cotangents is negative.
FlattenInput sheared_plate() {
  return test::make_grid(8, 8, [](double s, double t) { return Eigen::Vector3d(s - 3 * t, t, 0); });
}

struct Case {
  const char* name;
  FlattenInput input;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class CircleEmbedding : public testing::TestWithParam<Case> {};

TEST_P(CircleEmbedding, FlipsNoTriangle) {
  const Charts charts = test::charts_of(GetParam().input);
  const Chart& chart = charts.charts.at(0);
  const Positions2 uv = tutte_embedding(chart);
  EXPECT_GT(smallest_area(chart, uv), 0);
  for (const HalfedgeHandle h : chart.boundary_loops.front()) {
    const double r = uv.row(chart.mesh.from_vertex_handle(h).idx()).norm();
    EXPECT_NEAR(r * r * kPi, area_3d(chart), 1e-12 * area_3d(chart));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, CircleEmbedding,
                         testing::Values(Case{"quarter_sphere", test::quarter_sphere(8)},
                                         Case{"two_holes", rolled_plate_with_two_holes()}, Case{"darts", cut_square()},
                                         Case{"tube", test::cylinder_tube(24, 8, 1, 2)},
                                         Case{"strip", test::flat_rectangle(40, 1, 40, 1)},
                                         Case{"gore", test::sphere_of_gores(6, 3, 12)},
                                         Case{"slivers", sliver_plate()}),
                         [](const auto& tested) { return std::string(tested.param.name); });

class Developable : public testing::TestWithParam<Case> {};

/// Toward E = 0 every step lowers E by a good part of it, so the iteration ends in rounding.
TEST_P(Developable, ComesOutWithItsLengths) {
  const Charts charts = test::charts_of(GetParam().input);
  const Chart& chart = charts.charts.at(0);
  const FreeBoundaryArap flat = free_boundary_arap(chart, kUntilConverged);
  EXPECT_TRUE(flat.converged);
  EXPECT_LT(largest_stretch(chart, flat.uv), 1e-13);
  EXPECT_GT(smallest_area(chart, flat.uv), 0);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Developable,
                         testing::Values(Case{"cylinder", test::cylinder_patch(16, 12, 1, 2.5, 1.5)},
                                         Case{"cone", test::cone_patch(16, 12, 1, 3, 0.5, 4)},
                                         Case{"plate_with_holes", rolled_plate_with_two_holes()},
                                         Case{"darts", cut_square()}, Case{"strip", test::flat_rectangle(12, 1, 12, 1)},
                                         Case{"slivers", sliver_plate()}, Case{"negative_cotangents", sheared_plate()}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(FreeArap, ReachesTheKnownEnergyOfTheQuarterSphere) {
  const Charts charts = test::charts_of(test::quarter_sphere(16));
  const Chart& chart = charts.charts.at(0);
  const FreeBoundaryArap flat = free_boundary_arap(chart, kUntilConverged);
  EXPECT_TRUE(flat.converged);
  EXPECT_EQ(flat.factorizations, 2);
  EXPECT_LE(flat.iterations, 10);
  EXPECT_NEAR(flat.energy / area_3d(chart), 0.00421971, 0.01 * 0.00421971);  // computed independently
  EXPECT_EQ(ShapeError(chart).energy(flat.uv), flat.energy);
}

TEST(FreeArap, StopsAtAnyStepWhenAsked) {
  const Charts charts = test::charts_of(test::quarter_sphere(16));
  for (int steps = 0; steps < 4; ++steps) {
    int asked = 0;
    const StopToken stop([&](const char*) { return asked++ < steps; });
    EXPECT_THROW(free_boundary_arap(charts.charts.at(0), kUntilConverged, {}, stop), Stopped);
    EXPECT_EQ(asked, steps + 1);
  }
}

/// Bending a long strip as a whole costs next to nothing: steps that know nothing of each other hardly move it.
TEST(FreeArap, UnrollsALongStripByConjugateSteps) {
  const Charts charts = test::charts_of(test::cone_patch(48, 4, 10, 11, 0.5, 4));
  const Chart& chart = charts.charts.at(0);
  Positions2 uv = tutte_embedding(chart);
  for (int step = 0; step < 100; ++step) uv = free_boundary_arap(chart, 1, uv).uv;
  EXPECT_LT(free_boundary_arap(chart, 30).energy, ShapeError(chart).energy(uv));
}

class FreeArapOnASphere : public testing::Test {
 protected:
  const FlattenInput input = test::quarter_sphere(6);
  const Charts charts = test::charts_of(input);
  const Chart& chart = charts.charts.at(0);
};

TEST_F(FreeArapOnASphere, NeverRaisesTheEnergy) {
  // From shapes with half of the triangles flipped, where the first steps are large.
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 5; ++trial) {
    Positions2 start(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
    for (double& x : start.reshaped()) x = normal(random);
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

TEST_F(FreeArapOnASphere, TurnsAMirroredStartOver) {
  const Positions2 start = tutte_embedding(chart);
  const Positions2 mirrored = start * Eigen::Vector2d(-1, 1).asDiagonal();
  EXPECT_EQ(free_boundary_arap(chart, 10, mirrored).uv, free_boundary_arap(chart, 10, start).uv);
}

TEST_F(FreeArapOnASphere, ScalesWithTheChart) {
  const FreeBoundaryArap flat = free_boundary_arap(chart, 30);
  for (const double scale : {1e-3, 39.37}) {
    FlattenInput scaled = input;
    scaled.vertices *= scale;
    const FreeBoundaryArap large = free_boundary_arap(test::charts_of(scaled).charts.at(0), 30);
    EXPECT_EQ(large.iterations, flat.iterations);
    EXPECT_LT((large.uv / scale - flat.uv).norm(), 1e-10 * flat.uv.norm());
    EXPECT_NEAR(large.energy, scale * scale * flat.energy, 1e-10 * scale * scale * flat.energy);
  }
}

TEST_F(FreeArapOnASphere, DoesNotDependOnTheOrderOfVerticesAndFaces) {
  std::mt19937 random(2);
  std::vector<int> new_index(static_cast<std::size_t>(input.vertices.rows()));
  std::iota(new_index.begin(), new_index.end(), 0);
  std::shuffle(new_index.begin(), new_index.end(), random);
  FlattenInput shuffled;
  shuffled.vertices.resize(input.vertices.rows(), 3);
  shuffled.faces.resize(input.faces.rows(), 3);
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    shuffled.vertices.row(new_index[v]) = input.vertices.row(static_cast<Eigen::Index>(v));
  }
  for (Eigen::Index f = 0; f < input.faces.rows(); ++f) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const int vertex = input.faces(input.faces.rows() - 1 - f, (k + f) % 3);
      shuffled.faces(f, k) = new_index[static_cast<std::size_t>(vertex)];
    }
  }
  const Charts shuffled_charts = test::charts_of(shuffled);
  const Chart& shuffled_chart = shuffled_charts.charts.at(0);
  const auto by_input_vertex = [](const Chart& from, const Positions2& uv) {
    Positions2 sorted(uv.rows(), 2);
    for (Eigen::Index v = 0; v < uv.rows(); ++v)
      sorted.row(from.source_vertex[static_cast<std::size_t>(v)]) = uv.row(v);
    return sorted;
  };
  const FreeBoundaryArap flat = free_boundary_arap(chart, kUntilConverged);
  const FreeBoundaryArap other = free_boundary_arap(shuffled_chart, kUntilConverged);
  EXPECT_NEAR(other.energy, flat.energy, 1e-9 * flat.energy);
  const Positions2 uv = by_input_vertex(chart, flat.uv), other_sorted = by_input_vertex(shuffled_chart, other.uv);
  Positions2 other_uv(uv.rows(), 2);
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    other_uv.row(static_cast<Eigen::Index>(v)) = other_sorted.row(new_index[v]);
  }
  EXPECT_LT((moved_onto(other_uv, uv) - uv).norm(), 1e-9 * uv.norm());
}

}  // namespace
}  // namespace wirewarp::test_free_boundary_arap
