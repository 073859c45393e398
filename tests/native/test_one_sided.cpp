// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that no turning of faces orients.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/planar.h"
#include "test_meshes.h"

namespace wirewarp::test_one_sided {
namespace {

TEST(OneSidedSurface, AMobiusStripIsCutWhereItsFacesTurn) {
  constexpr int n = 12;
  FlattenInput strip;
  strip.vertices.resize(2 * n, 3);
  strip.faces.resize(2 * n, 3);
  for (int i = 0; i < n; ++i) {
    const double around = 2 * kPi * i / n, twist = around / 2;
    for (const int side : {0, 1}) {
      const double across = side == 0 ? -0.2 : 0.2, radius = 1 + across * std::cos(twist);
      strip.vertices.row(2 * i + side) << radius * std::cos(around), radius * std::sin(around),
          across * std::sin(twist);
    }
    const bool is_last = i + 1 == n;  // the strip meets itself upside down
    const int a = 2 * i, b = 2 * i + 1, c = is_last ? 1 : a + 2, d = is_last ? 0 : b + 2;
    strip.faces.row(2 * i) << a, c, b;
    strip.faces.row(2 * i + 1) << b, c, d;
  }
  const FlattenResult refused = flatten(strip);
  ASSERT_TRUE(refused.pieces.at(0).error);
  const FlattenError& error = *refused.pieces[0].error;
  EXPECT_EQ(error.code, ErrorCode::inconsistent_orientation);
  EXPECT_NE(std::string(error.what()).find("one-sided"), std::string::npos) << error.what();
  ASSERT_FALSE(error.elements.proposed_seams.empty());
  for (const VertexPair& pair : error.elements.proposed_seams) test::add_seam(strip, {pair[0], pair[1]});
  const FlattenResult result = flatten(strip);
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_FALSE(result.pieces[0].error) << result.pieces[0].error->what();
}

}  // namespace
}  // namespace wirewarp::test_one_sided
