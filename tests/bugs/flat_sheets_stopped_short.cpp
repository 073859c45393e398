// SPDX-License-Identifier: GPL-3.0-or-later
// Flat sheets stopped close to their shape: strained, "stopped short", flipped, or overlapping along a slit. For edges
// of a millionth of the piece, bending is stiffer than doubles can represent beside the other terms; and flat nets of
// rigid wires are rigid only to second order.
#include <gtest/gtest.h>

#include <cmath>

#include "test_meshes.h"

namespace wirewarp::flat_sheets_stopped_short_test {
namespace {

constexpr double kRounding = 1e-20;  // rounding error of E, for strains of 1e-10

void expect_flat_without_strain(const FlattenInput& input) {
  for (const Piece& piece : flatten(input).pieces) {
    EXPECT_FALSE(piece.error) << piece.error->what();
    EXPECT_EQ(piece.report.termination, Termination::converged);
    EXPECT_LE(piece.metrics.arap_energy, kRounding);
  }
}

/// Returns a sheet of width 1 whose columns become narrower towards the left.
FlattenInput graded_sheet(int n, double ratio, double height) {
  return test::make_grid(n, n, [=](double s, double t) -> Eigen::Vector3d {
    return {s > 0 ? std::pow(ratio, n * (1 - s)) : 0, height * t, 0};
  });
}

std::vector<int> first_vertices(const std::vector<int>& line, std::ptrdiff_t count) {
  return {line.begin(), line.begin() + count};
}

TEST(Bugs, AFlatSheetWithASlitIsNotStrained) {
  FlattenInput input = graded_sheet(6, 0.1, 1);
  test::add_seam(input, first_vertices(test::grid_column(6, 6, 3), 4));
  expect_flat_without_strain(input);
}

TEST(Bugs, AFlatSheetDoesNotOverlapItselfAlongASlit) {
  FlattenInput input = graded_sheet(8, 0.2, 1);
  test::add_seam(input, first_vertices(test::grid_column(8, 8, 5), 5));
  expect_flat_without_strain(input);
}

TEST(Bugs, AFlatSheetWithShortEdgesIsNotFlipped) {
  FlattenInput input = graded_sheet(10, 0.1, 20);
  test::add_seam(input, first_vertices(test::grid_row(10, 9), 7));
  test::add_wire(input, test::grid_column(10, 10, 1));
  expect_flat_without_strain(input);
}

TEST(Bugs, AFlatNetOfRigidWiresConverges) {
  FlattenInput input = test::flat_rectangle(2, 5, 34, 5);
  for (const std::vector<int>& edge : {std::vector<int>{6, 10}, {0, 4}, {7, 11}, {7, 10}, {1, 4}, {4, 7}, {6, 7}}) {
    test::add_wire(input, edge);
  }
  for (const std::vector<int>& edge : {std::vector<int>{4, 5}, {1, 5}}) test::add_wire(input, edge, 0.001);
  test::add_seam(input, {10, 11});
  expect_flat_without_strain(input);
}

}  // namespace
}  // namespace wirewarp::flat_sheets_stopped_short_test
