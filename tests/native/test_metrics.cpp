// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "base/planar.h"
#include "result/metrics.h"
#include "test_meshes.h"

namespace wirewarp::test_metrics {
namespace {

using test::charts_of;
using test::planar_positions;

Metrics measure(const Chart& chart, const Positions2& uv) {
  return measure_metrics(chart, build_wire_network(chart), uv);
}

/// Positions on the unrolled cylinder patch made by test::cylinder_patch.
Positions2 unrolled(const Chart& chart, double radius) {
  Positions2 uv(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  for (const VertexHandle v : chart.mesh.vertices()) {
    const HalfEdgeMesh::Point& p = chart.mesh.point(v);
    uv.row(v.idx()) << radius * std::atan2(p[1], p[0]), p[2];
  }
  return uv;
}

TEST(Metrics, StretchedSheetByArithmetic) {
  const int n = 4;
  FlattenInput input = test::flat_rectangle(n, n, 2, 2);
  test::add_wire(input, test::grid_row(n, 2));
  const Charts charts = charts_of(input);
  Positions2 uv = planar_positions(charts.charts[0]);
  uv.col(0) *= 1.1;
  const Metrics metrics = measure(charts.charts[0], uv);

  EXPECT_NEAR(metrics.area_3d, 4, 1e-14);
  EXPECT_NEAR(metrics.area_2d, 4 * 1.1, 1e-14);
  EXPECT_NEAR(metrics.arap_energy, 0.1 * 0.1, 1e-14);  // sigma 1.1 and 1 everywhere
  EXPECT_NEAR(metrics.face_arap.sum(), metrics.arap_energy * metrics.area_3d, 1e-14);
  EXPECT_NEAR(metrics.face_aspect_ratio.minCoeff(), 1.1, 1e-13);
  EXPECT_NEAR(metrics.face_aspect_ratio.maxCoeff(), 1.1, 1e-13);
  EXPECT_TRUE(metrics.flipped_faces.empty());
  EXPECT_TRUE(metrics.overlapping_faces.empty());

  // The wire's edges first, all across; then the outline's, across or upright.
  ASSERT_EQ(metrics.wire_edges.size(), static_cast<std::size_t>(n + 4 * n));
  for (std::size_t i = 0; i < metrics.wire_edges.size(); ++i) {
    const auto [a, b] = metrics.wire_edges[i];
    const bool is_across = input.vertices(a, 1) == input.vertices(b, 1);
    if (i < static_cast<std::size_t>(n)) {
      EXPECT_EQ(input.vertices(a, 1), 1) << "not on the wire";
    }
    EXPECT_NEAR(metrics.edge_length_variation[static_cast<Eigen::Index>(i)], is_across ? 0.1 : 0, 1e-14);
  }
}

TEST(Metrics, UnrolledCylinderIsIsometricUpToItsFacets) {
  // Every quad between two generators is flat; unrolled by its chord it keeps its shape.
  const int n = 12;
  const double angle = 2.0;
  const Charts charts = charts_of(test::cylinder_patch(n, 3, 1.5, angle, 1));
  Positions2 uv = unrolled(charts.charts[0], 1.5);
  uv.col(0) *= std::sin(angle / n / 2) / (angle / n / 2);
  const Metrics metrics = measure(charts.charts[0], uv);
  EXPECT_LT(metrics.arap_energy, 1e-26);
  EXPECT_NEAR(metrics.face_aspect_ratio.maxCoeff(), 1, 1e-13);
  EXPECT_LT(metrics.edge_length_variation.maxCoeff(), 1e-13);
  EXPECT_LT(metrics.angle_deviation_max, 1e-12);
}

TEST(Metrics, ShearTurnsTheFourCornersOnly) {
  const int n = 5;
  const Charts charts = charts_of(test::flat_rectangle(n, n, 1, 1));
  Positions2 uv = planar_positions(charts.charts[0]);
  uv.col(0) += uv.col(1) * std::tan(0.2);
  const Metrics metrics = measure(charts.charts[0], uv);
  EXPECT_NEAR(metrics.angle_deviation_max, 0.2, 1e-13);
  EXPECT_NEAR(metrics.angle_deviation_rms, std::sqrt(4 * 0.2 * 0.2 / (4 * n)), 1e-13);
}

TEST(Metrics, AnglesBeyondAHalfTurnAreNotWrapped) {
  // The nodes at the outline of a hole span 3π/2 at its corners.
  const Charts charts = charts_of(test::flat_plate_with_two_holes(4));
  const Chart& chart = charts.charts[0];
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
  test::add_wire(input, {12, 13});  // inside, meets nothing
  const Charts charts = charts_of(input);
  Positions2 uv = planar_positions(charts.charts[0]);
  uv.row(12) += Eigen::RowVector2d(0.01, 0.02);
  EXPECT_NEAR(measure(charts.charts[0], uv).angle_deviation_max, 0, 1e-14);
}

TEST(Metrics, FacesAreThoseOfTheInput) {
  // Two charts; the second is turned over as a whole.
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
  EXPECT_TRUE(metrics.overlapping_faces.empty()) << "the mirror image lies flat, face by face";
}

TEST(Metrics, SameAfterARigidMotionAndInAnyUnit) {
  const Charts charts = charts_of(test::quarter_sphere(6));
  const Chart& chart = charts.charts[0];
  const Positions2 uv = planar_positions(chart);
  const Metrics reference = measure(chart, uv);

  FlattenInput scaled = test::quarter_sphere(6);
  scaled.vertices *= 1000;
  const Charts scaled_charts = charts_of(scaled);
  Eigen::Matrix2d turn;
  turn << 0.6, 0.8, -0.8, 0.6;
  const Positions2 moved = (1000 * uv * turn).rowwise() + Eigen::RowVector2d(300, -2000);
  const Metrics metrics = measure(scaled_charts.charts[0], moved);

  EXPECT_NEAR(metrics.arap_energy, reference.arap_energy, 1e-11);
  EXPECT_NEAR(metrics.area_3d, 1e6 * reference.area_3d, 1e-6);
  EXPECT_NEAR(metrics.angle_deviation_rms, reference.angle_deviation_rms, 1e-11);
  EXPECT_TRUE(metrics.edge_length_variation.isApprox(reference.edge_length_variation, 1e-10));
}

}  // namespace
}  // namespace wirewarp::test_metrics
