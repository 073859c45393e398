// SPDX-License-Identifier: GPL-3.0-or-later
// A seam of one edge inside a piece took all 100 factorizations. The boundary turns back at both its ends, where the
// previous and the next vertex are the same, and the Hessian of the fairness did not contain their product.
#include <gtest/gtest.h>

#include "test_meshes.h"

namespace wirewarp::slit_of_one_edge_test {
namespace {

TEST(Bugs, ASlitOfOneEdgeTakesNoLongerThanAWire) {
  const auto saddle = [](double s, double t) {
    return Eigen::Vector3d(68 * s, 5 * t, 8.5 * ((s - 0.5) * (s - 0.5) - (t - 0.5) * (t - 0.5)));
  };
  FlattenInput input = test::make_grid(4, 5, saddle);
  test::add_seam(input, {18, 23});
  const FlattenResult result = flatten(input);
  ASSERT_FALSE(result.pieces.at(0).error);
  EXPECT_EQ(result.pieces[0].report.termination, Termination::converged);
  EXPECT_LE(result.pieces[0].report.factorizations, 5);
}

}  // namespace
}  // namespace wirewarp::slit_of_one_edge_test
