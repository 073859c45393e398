// SPDX-License-Identifier: GPL-3.0-or-later
// The search for cuts took a slit of one edge for a sewn one, because its rims connect the same two vertices. So it
// proposed a cut along the slit itself.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/planar.h"
#include "test_meshes.h"

namespace wirewarp::proposed_seam_along_a_slit_test {
namespace {

TEST(Bugs, NoSeamIsProposedAlongASlitOfOneEdge) {
  const int around = 4;
  FlattenInput input = test::make_tube(around, 8, [](double s, double t) {
    return Eigen::Vector3d(std::cos(2 * kPi * s), std::sin(2 * kPi * s), 8 * t);
  });
  for (int row = 1; row < 7; ++row) {
    const int below = row * around, above = below + around;
    FlattenInput slit = input;
    test::add_seam(slit, {below, above});
    const FlattenResult result = flatten(slit);
    ASSERT_TRUE(result.pieces.at(0).error) << row;
    const std::vector<VertexPair>& proposed = result.pieces[0].error->elements.proposed_seams;
    EXPECT_FALSE(proposed.empty()) << row;
    for (const VertexPair& seam : proposed) {
      EXPECT_NE((std::set<int>{seam[0], seam[1]}), (std::set<int>{below, above})) << row;
    }
  }
}

}  // namespace
}  // namespace wirewarp::proposed_seam_along_a_slit_test
