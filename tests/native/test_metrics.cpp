// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "base/planar.h"
#include "dense_algebra.h"
#include "result/metrics.h"
#include "surface/network/wire_network.h"
#include "test_meshes.h"

namespace wirewarp::test_metrics {
namespace {

using test::charts_of;
using test::planar_positions;

Metrics measure(const Chart& chart, const Positions2& uv) {
  return measure_metrics(chart, build_wire_network(chart), uv);
}

TEST(Metrics, StretchedSheetByArithmetic) {
  const int n = 4;
  FlattenInput input = test::flat_rectangle(n, n, 2, 2);
  test::add_wire(input, test::grid_row(n, 2));
  const Chart chart = test::chart_of(input);
  Positions2 uv = planar_positions(chart);
  uv.col(0) *= 1.1;
  const Metrics metrics = measure(chart, uv);

  EXPECT_NEAR(metrics.area_3d, 4, 1e-14);
  EXPECT_NEAR(metrics.area_2d, 4 * 1.1, 1e-14);
  EXPECT_NEAR(metrics.arap_energy, 0.1 * 0.1, 1e-14);  // the singular values are 1.1 and 1
  EXPECT_NEAR(metrics.face_arap.sum(), metrics.arap_energy * metrics.area_3d, 1e-14);
  EXPECT_NEAR(metrics.face_aspect_ratio.minCoeff(), 1.1, 1e-13);
  EXPECT_NEAR(metrics.face_aspect_ratio.maxCoeff(), 1.1, 1e-13);
  EXPECT_TRUE(metrics.flipped_faces.empty());
  EXPECT_TRUE(metrics.overlapping_faces.empty());

  // The wire's edges come first, and all run across. The outline's edges follow, and run across or upward.
  ASSERT_EQ(metrics.wire_edges.size(), static_cast<std::size_t>(n + 4 * n));
  for (std::size_t i = 0; i < metrics.wire_edges.size(); ++i) {
    const auto [a, b] = metrics.wire_edges[i];
    const bool is_across = input.vertices(a, 1) == input.vertices(b, 1);
    if (i < static_cast<std::size_t>(n)) {
      EXPECT_EQ(input.vertices(a, 1), 1) << "not on the wire";
    }
    EXPECT_NEAR(metrics.edge_length_variation[i], is_across ? 0.1 : 0, 1e-14);
  }
}

TEST(Metrics, ShearChangesOnlyTheFourCorners) {
  const int n = 5;
  const Chart chart = test::chart_of(test::flat_rectangle(n, n, 1, 1));
  Positions2 uv = planar_positions(chart);
  uv.col(0) += uv.col(1) * std::tan(0.2);
  const Metrics metrics = measure(chart, uv);
  EXPECT_NEAR(metrics.angle_deviation_max, 0.2, 1e-13);
  EXPECT_NEAR(metrics.angle_deviation_rms, std::sqrt(4 * 0.2 * 0.2 / (4 * n)), 1e-13);
}

TEST(Metrics, AnglesBeyondAHalfTurnAreNotWrapped) {
  // The nodes at the corners of a hole span 3π/2.
  const Chart chart = test::chart_of(test::flat_plate_with_two_holes(4));
  const WireNetwork network = build_wire_network(chart);
  const Positions2 uv = planar_positions(chart);
  int reflex = 0;
  for (const WireNode& node : network.nodes) {
    EXPECT_NEAR(planar_angle(chart, network, node, uv), node.surface_angle, 1e-13);
    reflex += node.surface_angle > 1.4 * kPi;
  }
  EXPECT_EQ(reflex, 8);
}

TEST(Metrics, TailsHaveNoAngle) {
  FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  test::add_wire(input, {12, 13});  // a wire inside that touches nothing
  const Chart chart = test::chart_of(input);
  Positions2 uv = planar_positions(chart);
  uv.row(12) += Eigen::RowVector2d(0.01, 0.02);
  EXPECT_NEAR(measure(chart, uv).angle_deviation_max, 0, 1e-14);
}

TEST(Metrics, FacesAreThoseOfTheInput) {
  const int n = 4;
  FlattenInput input = test::flat_rectangle(n, 2, 4, 2);
  test::add_seam(input, test::grid_column(n, 2, 2));
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts.size(), 2u);
  const Chart& right = charts.charts[1];
  Positions2 uv = planar_positions(right);
  EXPECT_TRUE(measure(right, uv).flipped_faces.empty());
  uv.col(0) *= -1;
  const Metrics metrics = measure(right, uv);
  EXPECT_EQ(metrics.flipped_faces, right.source_face);
  EXPECT_NE(metrics.flipped_faces, charts.charts[0].source_face);
  EXPECT_NEAR(metrics.area_2d, -4, 1e-14);
  EXPECT_TRUE(metrics.overlapping_faces.empty()) << "as a mirror image, no faces overlap";
}

using Planar = std::array<Eigen::Vector2d, 3>;

Metrics measure(const Planar& p, const Planar& u) {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()) *
                                    Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  FlattenInput input = test::mesh_of({{}, {}, {}}, {{0, 1, 2}});
  Positions2 uv(3, 2);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& corner = p[i];
    input.vertices.row(i) = rotation * Eigen::Vector3d(corner.x(), corner.y(), 0) + Eigen::Vector3d(3, -1, 2);
    uv.row(i) = u[i];
  }
  const Chart chart = test::chart_of(input);
  return measure_metrics(chart, build_wire_network(chart), uv);
}

Planar transformed(const Planar& p, const Eigen::Matrix2d& map) { return {map * p[0], map * p[1], map * p[2]}; }

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns Eq. (6) as in the paper: a sum over the edges with the cotangent of the opposite angle and the best
/// rotation.
double literal_arap(const Planar& p, const Planar& u) {
  std::array<double, 3> cotangents;
  double cosine = 0, sine = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    cotangents[i] = (p[i] - p[k]).dot(p[j] - p[k]) / cross(p[i] - p[k], p[j] - p[k]);
    cosine += cotangents[i] * (p[i] - p[j]).dot(u[i] - u[j]);
    sine += cotangents[i] * cross(p[i] - p[j], u[i] - u[j]);
  }
  const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(std::atan2(sine, cosine)).toRotationMatrix();
  double energy = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    energy += 0.5 * cotangents[i] * ((u[i] - u[j]) - rotation * (p[i] - p[j])).squaredNorm();
  }
  return energy;
}

const Planar kTriangle = {Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 0), Eigen::Vector2d(0.5, 1)};  // area 1

TEST(Arap, EqualsTheCotangentFormulaOfThePaper) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Eigen::MatrixXd corners = test::random_normal(2, 6, seed);
    Planar p{corners.col(0), corners.col(1), corners.col(2)};
    const Planar u{corners.col(3), corners.col(4), corners.col(5)};
    if (cross(p[1] - p[0], p[2] - p[0]) < 0) std::swap(p[1], p[2]);
    if (cross(p[1] - p[0], p[2] - p[0]) < 0.05) continue;
    const double expected = literal_arap(p, u);
    EXPECT_NEAR(measure(p, u).face_arap[0], expected, 1e-11 * (1 + expected));
  }
}

TEST(Arap, KnownMapsHaveTheirFigures) {
  struct Known {
    Eigen::Matrix2d map;
    double aspect_ratio, area, energy;
  };
  const auto turn = [](double angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); };
  const auto stretch = [](double x, double y) -> Eigen::Matrix2d { return Eigen::Vector2d(x, y).asDiagonal(); };
  const std::vector<Known> all{{turn(0.7) * stretch(1.25, 0.8) * turn(2), 1.25, 1.25 * 0.8, 0.25 * 0.25 + 0.2 * 0.2},
                               {turn(-2.5), 1, 1, 0},
                               {stretch(4, 4), 4, 4 * 4, 2 * 3 * 3},
                               {stretch(0.25, 0.25), 4, 0.25 * 0.25, 2 * 0.75 * 0.75},
                               {stretch(-1, 1), 1, -1, (1 - 1) * (1 - 1) + (-1 - 1) * (-1 - 1)}};
  for (const Known& known : all) {
    const Metrics t = measure(kTriangle, transformed(kTriangle, known.map));
    EXPECT_NEAR(t.face_aspect_ratio[0], known.aspect_ratio, 1e-13);
    EXPECT_NEAR(t.area_3d, 1, 1e-14);
    EXPECT_NEAR(t.area_2d, known.area, 1e-13);
    EXPECT_NEAR(t.face_arap[0], known.energy, 1e-13);
  }
  const Metrics collapsed = measure(kTriangle, transformed(kTriangle, stretch(0, 0)));
  EXPECT_EQ(collapsed.face_aspect_ratio[0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(collapsed.area_2d, 0);
  EXPECT_NEAR(collapsed.face_arap[0], 2, 1e-14);  // (0-1)² twice
}

}  // namespace
}  // namespace wirewarp::test_metrics
