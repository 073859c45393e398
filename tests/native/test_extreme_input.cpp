// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of extreme but valid input, which some files contain.
#include <gtest/gtest.h>

#include <cmath>

#include "base/planar.h"
#include "closed_meshes.h"
#include "error_of.h"
#include "test_meshes.h"

namespace wirewarp::test_extreme_input {
namespace {

Eigen::Vector3d dome(double s, double t) { return {s, t, 0.2 * std::cos(kPi * (s - 0.5)) * std::cos(kPi * (t - 0.5))}; }

FlattenInput dome_with_wires() {
  FlattenInput input = test::make_grid(10, 10, dome);
  test::add_wire(input, test::grid_row(10, 5));
  test::add_wire(input, test::grid_column(10, 10, 3), 0.05);
  return input;
}

void expect_flat(const FlattenInput& input) {
  for (const Method method : {Method::refined, Method::wirewarp_plus_plus, Method::wirewarping}) {
    Options options = test::by(method);
    const FlattenResult result = flatten(input, options);
    SCOPED_TRACE(result.method);
    test::expect_good(input, result, options);
  }
}

TEST(ExtremeInput, AnglesOfAMillionth) {
  FlattenInput input = dome_with_wires();
  for (const int v : test::grid_row(10, 5)) {  // the rigid wire is 1e-6 above the row below it
    input.vertices.row(v) = input.vertices.row(v - 11) + 1e-5 * (input.vertices.row(v) - input.vertices.row(v - 11));
  }
  expect_flat(input);
}

TEST(ExtremeInput, ATriangleAMillionTimesAsWideAsHigh) {
  expect_flat(test::mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-6, 0}}, {{0, 1, 2}}));
}

TEST(ExtremeInput, EdgesThatDifferByAMillion) {
  FlattenInput input = test::make_grid(10, 10, [](double s, double t) { return dome(std::pow(1e-6, 1 - s), t); });
  test::add_wire(input, test::grid_row(10, 5));
  expect_flat(input);
}

TEST(ExtremeInput, EdgesThatDifferByAMillionDoNotStopTheRefinedMethod) {
  // In the second case, the distances between rows differ by a factor of a million, too. The bending stiffness at the
  // shortest edges is then a million times that of the sheet.
  for (const bool in_both : {false, true}) {
    FlattenInput input = test::make_grid(
        10, 10, [&](double s, double t) { return dome(std::pow(1e-6, 1 - s), in_both ? std::pow(1e-6, 1 - t) : t); });
    test::add_wire(input, test::grid_row(10, 5));
    test::add_wire(input, test::grid_column(10, 10, 3), 0.05);
    const Piece piece = flatten(input).pieces.at(0);
    EXPECT_FALSE(piece.error) << piece.error->what();
    EXPECT_EQ(piece.report.termination, Termination::converged);
  }
}

TEST(ExtremeInput, AMillionSidesAway) {
  FlattenInput input = dome_with_wires();
  input.vertices.rowwise() += Eigen::RowVector3d(1e6, -1e6, 1e6);
  expect_flat(input);
}

TEST(ExtremeInput, TinyBesideHuge) {
  FlattenInput tiny = dome_with_wires(), huge = dome_with_wires();
  tiny.vertices *= 1e-4;
  huge.vertices *= 1e5;
  expect_flat(test::beside(tiny, huge, 0));
}

/// The solver must converge although rounding of the coordinates causes strains of 1e-11.
TEST(ExtremeInput, AFlatStripThirtyThousandTimesAsLongAsWide) {
  for (const int n : {1, 100}) {
    const FlattenResult result = flatten(test::flat_rectangle(n, 4, 1, 3e-5));
    EXPECT_FALSE(result.pieces[0].error);
    EXPECT_EQ(result.pieces[0].report.termination, Termination::converged) << n;
    EXPECT_LT(result.pieces[0].report.objective, 1e-20) << n;
  }
}

TEST(ExtremeInput, AThousandChartsOfOneTriangleInTheSamePlace) {
  FlattenInput input;
  input.vertices.resize(3000, 3);
  input.faces.resize(1000, 3);
  for (int f = 0; f < 1000; ++f) {
    input.vertices.middleRows(3 * f, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    input.faces.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
  }
  EXPECT_EQ(flatten(input).pieces.size(), 1000U);
  expect_flat(input);
}

TEST(ExtremeInput, AWireOnEveryEdgeOfAFlatPatch) {
  FlattenInput input = test::flat_rectangle(12, 12, 1, 1);
  test::add_wires_on_edges(input);
  for (const auto& side :
       {test::grid_row(12, 0), test::grid_row(12, 12), test::grid_column(12, 12, 0), test::grid_column(12, 12, 12)}) {
    for (int i = 0; i < 12; ++i) test::add_wire(input, test::section(side, i, i + 1));
  }
  expect_flat(input);
}

TEST(ExtremeInput, FiveHundredWiresOnOneChart) {
  FlattenInput input = test::make_grid(60, 60, dome);
  for (int row = 2; row < 58; row += 2) {
    for (int i = 2; i < 55; i += 3) test::add_wire(input, test::section(test::grid_row(60, row), i, i + 2));
  }
  input.wires.resize(500);
  test::expect_good(input, flatten(input));
}

}  // namespace
}  // namespace wirewarp::test_extreme_input
