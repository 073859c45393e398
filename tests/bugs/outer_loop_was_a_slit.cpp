// SPDX-License-Identifier: GPL-3.0-or-later
// On a rough surface, a slit that turns more to the left than the outline was taken for the outer loop. The other slits
// were sewn without it, its rims still became one edge, and memory was written at index -1.
#include <gtest/gtest.h>

#include "surface/charts/slits.h"
#include "test_meshes.h"

namespace wirewarp::outer_loop_was_a_slit_test {
namespace {

/// Returns a sheet with a slit of one edge, which has a high spike at one end and a low one at the other. The slit
/// therefore turns by nearly 2 pi.
FlattenInput rough_sheet_with_two_slits() {
  FlattenInput input = test::make_grid(6, 6, [](double s, double t) {
    const bool is_spike = std::abs(s - 0.5) < 1e-9 && (std::abs(t - 0.5) < 1e-9 || std::abs(t - 1.0 / 3) < 1e-9);
    const bool is_corner = (s == 0 || s == 1) && (t == 0 || t == 1);
    return Eigen::Vector3d(s, t, is_spike ? 20 : is_corner ? 0.3 : 0);
  });
  test::add_seam(input, {3 + 7 * 2, 3 + 7 * 3});  // joins both spikes
  test::add_seam(input, {1 + 7 * 5, 2 + 7 * 5});
  return input;
}

TEST(Bugs, TheOuterLoopIsNotASlit) {
  const FlattenInput input = rough_sheet_with_two_slits();
  const Chart chart = test::charts_of(input).charts.at(0);
  ASSERT_EQ(chart.boundary_loops.size(), 3U);
  EXPECT_EQ(chart.boundary_loops[0].size(), 24U);  // the outline of 6 by 6 quads
  EXPECT_EQ(find_slits(chart).size(), 2U);
  EXPECT_EQ(flatten(input).pieces.size(), 1U);
}

TEST(Bugs, TheOutlineOfAClosedSurfaceWithTwoSlitsIsOneOfThem) {
  FlattenInput input = test::make_tube(6, 2, [](double s, double t) {
    const double angle = 2 * 3.141592653589793 * s;
    return Eigen::Vector3d(std::cos(angle), std::sin(angle), t);
  });
  const int bottom = 18, top = 19;
  input.vertices.conservativeResize(20, 3);
  input.vertices.bottomRows(2) << 0, 0, -1, 0, 0, 2;
  const Eigen::Index num_faces = input.faces.rows();
  input.faces.conservativeResize(num_faces + 12, 3);
  for (int i = 0; i < 6; ++i) {
    const int next = (i + 1) % 6;
    input.faces.row(num_faces + 2 * i) << bottom, next, i;
    input.faces.row(num_faces + 2 * i + 1) << top, 12 + i, 12 + next;
  }
  test::add_seam(input, {6, 7});
  test::add_seam(input, {9, 10});
  const FlattenResult result = flatten(input);
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_TRUE(result.pieces[0].error) << "the outline has no area";
}

}  // namespace
}  // namespace wirewarp::outer_loop_was_a_slit_test
