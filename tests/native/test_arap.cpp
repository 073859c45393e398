// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "result/metrics.h"
#include "surface/network/wire_network.h"
#include "test_meshes.h"

namespace wirewarp::test_arap {
namespace {

using Planar = std::array<Eigen::Vector2d, 3>;

/// Of one triangle: p put into space by a rigid motion, mapped to u.
Metrics measure(const Planar& p, const Planar& u) {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()) *
                                    Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  FlattenInput input;
  input.vertices.resize(3, 3);
  input.faces.resize(1, 3);
  input.faces << 0, 1, 2;
  Positions2 uv(3, 2);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& corner = p[static_cast<std::size_t>(i)];
    input.vertices.row(i) = rotation * Eigen::Vector3d(corner.x(), corner.y(), 0) + Eigen::Vector3d(3, -1, 2);
    uv.row(i) = u[static_cast<std::size_t>(i)];
  }
  const Charts charts = test::charts_of(input);
  return measure_metrics(charts.charts.at(0), build_wire_network(charts.charts.at(0)), uv);
}

Planar transformed(const Planar& p, const Eigen::Matrix2d& map) { return {map * p[0], map * p[1], map * p[2]}; }

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Eq. (6) as it is written: over the edges, with the cotangent of the angle opposite and the best rotation.
double literal_arap(const Planar& p, const Planar& u) {
  std::array<double, 3> cotangents;
  double cosine = 0;
  double sine = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
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
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    Planar p;
    Planar u;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = {normal(random), normal(random)};
      u[i] = {normal(random), normal(random)};
    }
    if (cross(p[1] - p[0], p[2] - p[0]) < 0) std::swap(p[1], p[2]);
    if (cross(p[1] - p[0], p[2] - p[0]) < 0.05) continue;
    const double expected = literal_arap(p, u);
    EXPECT_NEAR(measure(p, u).face_arap[0], expected, 1e-11 * (1 + expected));
  }
}

TEST(Arap, SingularValuesOfAStretchTurnedBothWays) {
  const Eigen::Matrix2d map =
      Eigen::Rotation2Dd(0.7) * Eigen::Vector2d(1.25, 0.8).asDiagonal() * Eigen::Rotation2Dd(2.0);
  const Metrics t = measure(kTriangle, transformed(kTriangle, map));
  EXPECT_NEAR(t.face_aspect_ratio[0], 1.25, 1e-14);
  EXPECT_NEAR(t.area_3d, 1, 1e-14);
  EXPECT_NEAR(t.area_2d, 1.25 * 0.8, 1e-14);
  EXPECT_NEAR(t.face_arap[0], 0.25 * 0.25 + 0.2 * 0.2, 1e-14);
}

TEST(Arap, IsometryHasNoDistortion) {
  const Metrics t = measure(kTriangle, transformed(kTriangle, Eigen::Rotation2Dd(-2.5).toRotationMatrix()));
  EXPECT_NEAR(t.face_aspect_ratio[0], 1, 1e-14);
  EXPECT_LT(t.face_arap[0], 1e-28);
}

TEST(Arap, AspectRatioCountsShrinkingAsMuchAsStretching) {
  EXPECT_NEAR(measure(kTriangle, transformed(kTriangle, Eigen::Matrix2d::Identity() * 4)).face_aspect_ratio[0], 4,
              1e-13);
  EXPECT_NEAR(measure(kTriangle, transformed(kTriangle, Eigen::Matrix2d::Identity() / 4)).face_aspect_ratio[0], 4,
              1e-13);
}

TEST(Arap, MirrorImageIsFlipped) {
  const Metrics t = measure(kTriangle, transformed(kTriangle, Eigen::Vector2d(-1, 1).asDiagonal()));
  EXPECT_NEAR(t.area_2d, -1, 1e-14);
  EXPECT_NEAR(t.face_arap[0], 4, 1e-13);  // (1-1)² + (-1-1)², area 1
  EXPECT_NEAR(t.face_aspect_ratio[0], 1, 1e-14);
}

TEST(Arap, CollapsedTriangleHasInfiniteAspectRatio) {
  const Planar point = {Eigen::Vector2d(1, 1), Eigen::Vector2d(1, 1), Eigen::Vector2d(1, 1)};
  const Metrics t = measure(kTriangle, point);
  EXPECT_EQ(t.face_aspect_ratio[0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(t.area_2d, 0);
  EXPECT_NEAR(t.face_arap[0], 2, 1e-14);  // (0-1)² twice
}

}  // namespace
}  // namespace wirewarp::test_arap
