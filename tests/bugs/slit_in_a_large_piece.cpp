// SPDX-License-Identifier: GPL-3.0-or-later
// A seam of one edge inside a large piece: both its sides connect the same two vertices. Coarsening confused them and
// read past the end of the other one's run.
#include <gtest/gtest.h>

#include "test_meshes.h"

namespace wirewarp::slit_in_a_large_piece_test {
namespace {

TEST(Bugs, ALargePieceMayHaveASlitOfOneEdge) {
  const int n = 104;
  FlattenInput input = test::make_grid(
      n, n, [](double s, double t) { return Eigen::Vector3d(s, t, 0.3 * (s * (1 - s) + t * (1 - t))); });
  const int middle = test::nearest_vertex(input, {0.5, 0.5, 0.15});
  test::add_seam(input, {middle, middle + 1});
  Options options;
  options.fairness = 0.3;
  options.max_factorizations = 1;
  const FlattenResult result = flatten(input, options);
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_FALSE(result.pieces[0].error) << result.pieces[0].error->what();
  EXPECT_EQ(result.seams.at(0).mismatch, 0);
}

}  // namespace
}  // namespace wirewarp::slit_in_a_large_piece_test
