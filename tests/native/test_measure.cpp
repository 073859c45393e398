// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of flattenings by other programs. Inexact flattenings can be measured, but torn flattenings cannot.
#include <gtest/gtest.h>

#include <cmath>

#include "test_meshes.h"

namespace wirewarp::test_measure {
namespace {

TEST(Measure, ATornFlatteningIsRefused) {
  // A square of 4 by 4 quads. The corners of the upper half on row 2 are moved by 0.02, except at the ends of the row.
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  CornerUv torn(input.faces.rows(), 6);
  for (int f = 0; f < input.faces.rows(); ++f) {
    const bool is_above = f >= input.faces.rows() / 2;
    for (int k = 0; k < 3; ++k) {
      const int v = input.faces(f, k);
      torn.block<1, 2>(f, 2 * k) = input.vertices.row(v).head<2>();
      if (is_above && v > 10 && v < 14) torn(f, 2 * k) += 0.02;
    }
  }
  for (const Eigen::RowVector2d& offset : {Eigen::RowVector2d(0, 0), Eigen::RowVector2d(1e5, 0)}) {
    CornerUv moved = torn;
    for (int k = 0; k < 3; ++k) moved.middleCols<2>(2 * k).rowwise() += offset;
    const FlattenResult result = measure(input, moved);
    ASSERT_TRUE(result.pieces[0].error.has_value());
    EXPECT_EQ(result.pieces[0].error->code, ErrorCode::uv_discontinuous);
    EXPECT_EQ(result.pieces[0].error->elements.vertices, (std::vector<int>{11, 12, 13}));
    EXPECT_EQ(result.pieces[0].error->elements.edges,
              (std::vector<VertexPair>{{10, 11}, {11, 12}, {12, 13}, {13, 14}}));
  }
}

TEST(Measure, RoundedCornersAreNotATear) {
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  CornerUv corners = flatten(input).corner_uv;
  for (int i = 0; i < corners.size(); ++i) corners.data()[i] += (i / 6 % 2 == 0 ? 1e-9 : -1e-9);
  const FlattenResult result = measure(input, corners);
  EXPECT_NE(result.pieces[0].error.value_or(FlattenError(ErrorCode::cancelled, "")).code, ErrorCode::uv_discontinuous);
}

TEST(Measure, ReportsTimesAndThatNothingWasSolved) {
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  const FlattenResult result = measure(input, flatten(input).corner_uv);
  EXPECT_GE(result.seconds.at("total"), result.seconds.at("charts") + result.seconds.at("measure"));
  EXPECT_EQ(result.pieces[0].report.termination, Termination::measured);
  EXPECT_TRUE(std::isnan(result.pieces[0].report.constraint_residual));
}

TEST(Measure, AFlatteningWithMissingCoordinatesIsRefused) {
  const FlattenInput input = test::flat_rectangle(2, 2, 1, 1);
  CornerUv corners = flatten(input).corner_uv;
  for (const double bad : {std::nan(""), 1e200}) {
    corners(3, 2) = bad;
    const FlattenResult missing = measure(input, corners);
    ASSERT_TRUE(missing.pieces[0].error.has_value());
    EXPECT_EQ(missing.pieces[0].error->code, ErrorCode::no_layout);
    EXPECT_EQ(missing.pieces[0].error->elements.faces, std::vector<int>{3});
  }
}

}  // namespace
}  // namespace wirewarp::test_measure
