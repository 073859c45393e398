// SPDX-License-Identifier: GPL-3.0-or-later
// A failed piece that was flipped was upside down with Orientation::up: its area is negative, so the mean gradient over
// it had the wrong sign.
#include <gtest/gtest.h>

#include "surface/orientation/rising_direction.h"
#include "test_meshes.h"

namespace wirewarp::flipped_piece_upside_down_test {
namespace {

TEST(Bugs, AFlippedPieceIsUprightToo) {
  const Charts charts = test::charts_of(test::flat_rectangle(4, 3, 2, 1));
  const Positions2 uv = test::planar_positions(charts.charts.at(0));
  const Positions2 turned_over = uv * Eigen::Vector2d(-1, 1).asDiagonal();
  for (const Positions2& layout : {uv, turned_over}) {
    const Eigen::Vector2d rising = rising_direction(charts.charts[0], layout, {0, 1, 0});
    EXPECT_NEAR((rising.normalized() - Eigen::Vector2d(0, 1)).norm(), 0, 1e-12);
  }
}

}  // namespace
}  // namespace wirewarp::flipped_piece_upside_down_test
