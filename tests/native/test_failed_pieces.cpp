// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of charts that cannot be flattened.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/planar.h"
#include "base/sentence.h"
#include "error_of.h"
#include "newton/solve/chart_errors.h"
#include "surface/charts/isoperimetric.h"
#include "test_meshes.h"

namespace wirewarp::test_failed_pieces {
namespace {

void expect_no_figures(const FlattenInput& input, const Piece& piece) {
  const Metrics& metrics = piece.metrics;
  const auto num_faces = static_cast<Eigen::Index>(piece.source_face.size());
  ASSERT_EQ(piece.faces.rows(), num_faces);
  ASSERT_EQ(metrics.face_arap.size(), num_faces);
  ASSERT_EQ(metrics.face_aspect_ratio.size(), num_faces);
  ASSERT_EQ(piece.vertices.rows(), static_cast<Eigen::Index>(piece.source_vertex.size()));
  EXPECT_GT(piece.vertices.rows(), 0);
  EXPECT_TRUE(piece.vertices.array().isNaN().all());
  EXPECT_TRUE(metrics.face_arap.array().isNaN().all());
  EXPECT_TRUE(metrics.face_aspect_ratio.array().isNaN().all());
  for (const double figure :
       {metrics.arap_energy, metrics.angle_deviation_rms, metrics.angle_deviation_max, metrics.area_2d}) {
    EXPECT_TRUE(std::isnan(figure));
  }
  double area = 0;
  for (int f = 0; f < num_faces; ++f) {
    std::array<Eigen::Vector3d, 3> corner;
    for (int k = 0; k < 3; ++k) {
      const int v = input.faces(piece.source_face[f], k);
      EXPECT_EQ(piece.source_vertex[piece.faces(f, k)], v);
      corner[k] = input.vertices.row(v);
    }
    area += (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() / 2;
  }
  EXPECT_NEAR(metrics.area_3d, area, 1e-14);
}

TEST(FailedPieces, OtherChartsAreFlattenedIfOneIsBad) {
  const int n = 6;
  for (const std::size_t bad : {0u, 1u}) {
    FlattenInput input = test::flat_rectangle(n, n, 1, 1);
    test::add_seam(input, test::grid_column(n, n, 3));
    input.faces.conservativeResize(input.faces.rows() + 1, 3);
    input.faces.bottomRows(1) = input.faces.row(bad == 0 ? 0 : 2 * n - 1);
    const FlattenResult result = flatten(input);
    ASSERT_EQ(result.pieces.size(), 2u);
    ASSERT_TRUE(result.pieces[bad].error.has_value());
    EXPECT_FALSE(result.pieces[bad].error->has_layout);
    expect_no_figures(input, result.pieces[bad]);
    EXPECT_FALSE(result.pieces[1 - bad].error.has_value());
    const std::vector<int>& good = result.pieces[1 - bad].source_face;
    for (int f = 0; f < input.faces.rows(); ++f) {
      EXPECT_EQ(result.corner_uv.row(f).allFinite(), std::count(good.begin(), good.end(), f) > 0);
    }
    ASSERT_EQ(result.seams.size(), 1u);
    EXPECT_EQ(result.seams[0].pieces, (std::vector<int>{0, 1})) << "in the order of the pieces";
    EXPECT_TRUE(std::isnan(result.seams[0].mismatch));
    EXPECT_TRUE(std::isnan(result.seams[0].length_2d[bad]));
    EXPECT_NEAR(result.seams[0].length_2d[1 - bad], 1, 1e-9);
  }
}

TEST(FailedPieces, ReportTheirWorkButNoFiguresOfAShape) {
  for (const Method method : {Method::refined, Method::wirewarping}) {
    Options options = test::by(method);
    const Piece piece = flatten(test::saddle_of_wires(4, 0), options).pieces.at(0);
    test::expect_error(piece.error, ErrorCode::infeasible_lengths);
    EXPECT_EQ(piece.report.termination, Termination::failed);
    EXPECT_GT(piece.report.factorizations + piece.report.inner_solves, 0);
    EXPECT_TRUE(std::isnan(piece.report.constraint_residual));
    EXPECT_TRUE(std::isnan(piece.report.objective));
    EXPECT_TRUE(piece.report.warnings.empty());
  }
}

TEST(Isoperimetric, TheLeastShapeErrorIsThatOfTheBestSingularValues) {
  // If both singular values are s, then E / area = 2 (1 - s)^2, and the area ratio is s^2.
  for (const double s : {0.5, 0.6, 0.9, 1.0}) EXPECT_NEAR(least_shape_error(s * s), 2 * (1 - s) * (1 - s), 1e-15);
  // For area ratios below 1/4, the singular values are 1 - s and s. Then E / area = s^2 + (1 - s)^2, and the area ratio
  // is s (1 - s).
  for (const double s : {0.1, 0.3, 0.5}) {
    EXPECT_NEAR(least_shape_error(s * (1 - s)), s * s + (1 - s) * (1 - s), 1e-15);
  }
  EXPECT_EQ(least_shape_error(3), 0);
}

TEST(Isoperimetric, TheLeastShapeErrorIsConvex) {  // so no mix of area ratios has a smaller error than their mean
  const double step = 1. / 64;
  for (double share = step; share < 1.5; share += step) {
    const double chord = (least_shape_error(share - step) + least_shape_error(share + step)) / 2;
    EXPECT_LE(least_shape_error(share), chord + 1e-15) << share;
  }
}

TEST(InfeasibleOutline, NamesTheSeamThatItProposes) {
  const Chart chart = test::chart_of(test::cylinder_tube(16, 8, 1, 4));
  const FlattenError error = infeasible_outline(chart, Options{}, {{0, 16}}, false);
  EXPECT_EQ(error.elements.proposed_seams, (std::vector<VertexPair>{{0, 16}}));
  test::expect_words(error, "mark a seam, such as along edge 0-16.");
}

TEST(ShortOutline, NamesTheLongestOfManyOpenings) {
  int face = 0;
  const FlattenInput input =
      test::keep_faces(test::cylinder_tube(24, 24, 1, 6), [&](const Eigen::Vector3d&) { return face++ % 146 != 75; });
  const FlattenError error = test::expect_error(flatten(input).pieces.at(0).error, ErrorCode::boundary_too_short);
  test::expect_words(error, " and 5 more, can enclose");
  EXPECT_EQ(error.elements.vertices.size(), 10U);  // 2 ends and 8 holes
}

TEST(ShortOutline, ReportsTheLengthWithItsEase) {
  FlattenInput input = test::cylinder_tube(16, 4, 1, 6);
  test::add_wire(input, test::tube_ring(16, 0));
  input.wires[0].ease = 0.25;
  const std::optional<FlattenError> error = flatten(input).pieces.at(0).error;
  ASSERT_TRUE(error);
  const double around = 16 * 2 * std::sin(kPi / 16);
  test::expect_words(*error, "Its outlines, " + rounded(1.25 * around) + " units long at vertex ");
}

}  // namespace
}  // namespace wirewarp::test_failed_pieces
