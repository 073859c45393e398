// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines too short to hold their surface in the plane: the bound, and what is said of them.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "base/planar.h"
#include "base/sentence.h"
#include "newton/solve/chart_errors.h"
#include "surface/charts/isoperimetric.h"
#include "test_meshes.h"

namespace wirewarp::test_short_outline {
namespace {

TEST(Isoperimetric, TheLeastShapeErrorIsThatOfUniformShrinking) {
  // All singular values s: E / area = 2 (1 - s)^2, the share is s^2.
  for (const double s : {0.5, 0.6, 0.9, 1.0}) EXPECT_NEAR(least_shape_error(s * s), 2 * (1 - s) * (1 - s), 1e-15);
  // Below, one singular value is 1 - s, the other s: E / area = s^2 + (1 - s)^2, the share s (1 - s).
  for (const double s : {0.1, 0.3, 0.5}) {
    EXPECT_NEAR(least_shape_error(s * (1 - s)), s * s + (1 - s) * (1 - s), 1e-15);
  }
  EXPECT_EQ(least_shape_error(3), 0);
}

TEST(Isoperimetric, TheLeastShapeErrorIsConvex) {  // so that triangles of different shares cannot have less
  const double step = 1. / 64;
  for (double share = step; share < 1.5; share += step) {
    const double chord = (least_shape_error(share - step) + least_shape_error(share + step)) / 2;
    EXPECT_LE(least_shape_error(share), chord + 1e-15) << share;
  }
}

TEST(InfeasibleOutline, NamesTheSeamThatItProposes) {
  const Charts charts = test::charts_of(test::cylinder_tube(16, 8, 1, 4));
  const FlattenError error = infeasible_outline(charts.charts[0], Options{}, {{0, 16}}, false);
  EXPECT_EQ(error.elements.proposed_seams, (std::vector<VertexPair>{{0, 16}}));
  EXPECT_NE(std::string(error.what()).find("mark a seam, such as along edge 0-16."), std::string::npos) << error.what();
}

TEST(ShortOutline, OfManyOpeningsNamesTheLongest) {
  const int nx = 24, ny = 24;
  FlattenInput input = test::cylinder_tube(nx, ny, 1, 6);
  int face = 0;
  input = test::keep_faces(input, [&](const Eigen::Vector3d&) { return face++ % 146 != 75; });
  const FlattenResult result = flatten(input);
  ASSERT_TRUE(result.pieces.at(0).error);
  EXPECT_EQ(result.pieces[0].error->code, ErrorCode::boundary_too_short);
  const std::string message = result.pieces[0].error->what();
  EXPECT_NE(message.find(" and 5 more, can enclose"), std::string::npos) << message;
  EXPECT_EQ(result.pieces[0].error->elements.vertices.size(), 10U);  // 2 ends and 8 holes
}

TEST(ShortOutline, TellsTheLengthThatItsEaseLeavesIt) {
  FlattenInput input = test::cylinder_tube(16, 4, 1, 6);
  test::add_wire(input, test::tube_ring(16, 0));
  input.wires[0].ease = 0.25;
  const std::optional<FlattenError> error = flatten(input).pieces.at(0).error;
  ASSERT_TRUE(error);
  const double around = 16 * 2 * std::sin(kPi / 16);
  const std::string told = "its outlines, " + rounded(1.25 * around) + " units long at vertex ";
  EXPECT_NE(std::string(error->what()).find(told), std::string::npos) << error->what();
}

TEST(ShortOutline, SparesTheOtherPieces) {
  FlattenInput input = test::cylinder_tube(16, 8, 1, 6);
  test::add_seam(input, test::tube_ring(16, 4));
  for (int j = 0; j < 4; ++j) test::add_seam(input, {16 * j, 16 * (j + 1)});
  const FlattenResult result = flatten(input);
  ASSERT_EQ(result.pieces.size(), 2u);
  EXPECT_FALSE(result.pieces[0].error.has_value());
  ASSERT_TRUE(result.pieces[1].error.has_value());
  EXPECT_EQ(result.pieces[1].error->code, ErrorCode::boundary_too_short);
}

}  // namespace
}  // namespace wirewarp::test_short_outline
