// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of lines that are cut longer or shorter than on the surface, on all sides or on one side.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "eased_sheets.h"
#include "error_of.h"
#include "test_meshes.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test_ease {
namespace {

using Code = ErrorCode;
using test::ease_along;
using test::expect_good;
using test::seam_of_sheets;
using test::sheet_and_saddle;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ErrorCode code_thrown_by(const FlattenInput& input) {
  return test::error_of([&] { flatten(input); }).code;
}

/// A shortened grid of wires encloses the most area if its squares stay squares. So the whole sheet is scaled.
TEST(Ease, OfAllLinesScalesASheet) {
  const int n = 6;
  const double ease = -0.1;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_net(input, n, {0, 1, 2, 3, 4, 5, 6});
  for (Wire& wire : input.wires) wire.ease = ease;
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  const Metrics& metrics = result.pieces.at(0).metrics;
  EXPECT_NEAR(metrics.area_2d, (1 + ease) * (1 + ease), 1e-8);
  EXPECT_NEAR(result.pieces[0].report.objective, 2 * ease * ease, 1e-8) << "the ease costs no bending";
  EXPECT_NEAR(metrics.angle_deviation_max, 0, 1e-5);
  for (const WireReport& wire : result.wires) EXPECT_NEAR(wire.variation, ease, 1e-12);
}

TEST(Ease, OfASeamAppliesToAllItsSides) {
  for (const Method method : {Method::refined, Method::wirewarp_plus_plus, Method::wirewarping}) {
    FlattenInput input = sheet_and_saddle();
    test::add_wire(input, seam_of_sheets());
    input.wires.back().ease = 0.05;
    Options options = test::by(method);
    const FlattenResult result = flatten(input, options);
    const SeamReport& seam = result.seams.at(0);
    EXPECT_NEAR(seam.variation, 0.05, 1e-12);
    for (const double length : seam.length_2d) EXPECT_NEAR(length, 1.05 * seam.length_3d, 1e-8 * seam.length_3d);
    EXPECT_LT(seam.mismatch, 1e-9 * seam.length_3d);
    for (const Piece& piece : result.pieces) {
      EXPECT_FALSE(piece.error && piece.error->code == Code::lengths_not_kept);
    }
  }
}

TEST(Ease, OfOneSideDoesNotChangeTheOther) {
  FlattenInput input = sheet_and_saddle();
  input.eases.push_back(ease_along(seam_of_sheets(), 0.05));
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  const SeamReport& seam = result.seams.at(0);
  ASSERT_EQ(seam.length_2d.size(), 2u);
  // The seam runs upwards, and the sheet on its left is piece 0.
  EXPECT_NEAR(seam.length_2d[0], 1.05 * seam.length_3d, 1e-9);
  EXPECT_NEAR(seam.length_2d[1], seam.length_3d, 1e-9);
  EXPECT_NEAR(seam.eases[0], 0.05, 1e-12);
  EXPECT_NEAR(seam.eases[1], 0, 1e-12);
  EXPECT_LT(seam.mismatch, 1e-9);
}

TEST(Ease, BetweenTwoMarksAppliesToTheEdgesBetween) {
  FlattenInput input = sheet_and_saddle();
  input.eases.push_back(ease_along(test::section(seam_of_sheets(), 2, 5), 0.1));  // three of eight edges
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  EXPECT_NEAR(result.seams.at(0).eases[0], 0.1 * 3 / 8, 1e-9);
}

/// A strip of height H becomes a sector of a ring if one end becomes longer by the fraction r. At the distance y from
/// the other end, threads become longer by r y/H.
TEST(Ease, OfOneEndTurnsACylinderIntoASector) {
  const double ease = 0.05, height = 1;
  const int rows = 8;
  const auto total_energy = [&](int width) {
    FlattenInput input = test::cylinder_patch(width * rows, rows, 10, width / 10., height);
    test::add_wire(input, test::grid_row(width * rows, 0));
    input.wires.back().ease = ease;
    Options options;
    options.fairness = Options::least_fairness;  // so that corners change their angles at almost no cost
    const FlattenResult result = flatten(input, options);
    expect_good(input, result);
    EXPECT_NEAR(result.wires.at(0).length_2d, (1 + ease) * result.wires[0].length_3d, 1e-9);
    const Metrics& metrics = result.pieces.at(0).metrics;
    return metrics.arap_energy * metrics.area_3d;
  };
  // The mean of (r y/H)². Each triangle has the strain of the row that contains one of its edges.
  const double mean_square = ease * ease * (1. / 3 + 1. / (6 * rows * rows));
  // The energy of the strip's free sides does not depend on the width.
  EXPECT_NEAR(total_energy(8) - total_energy(4), mean_square * 4 * height, 0.01 * mean_square * 4 * height);
}

TEST(Ease, WithABadRatioOrBadEdgesIsAnError) {
  const std::vector<int> seam = seam_of_sheets();
  FlattenInput wire = sheet_and_saddle();
  test::add_wire(wire, seam);
  for (const double ease : {-1.0, -2.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    wire.wires[0].ease = ease;
    EXPECT_EQ(code_thrown_by(wire), Code::invalid_ease);
    FlattenInput side = sheet_and_saddle();
    side.eases.push_back(ease_along(seam, ease));
    EXPECT_EQ(code_thrown_by(side), Code::invalid_ease);
  }
  const auto with_ease = [](const std::vector<int>& chain) {
    FlattenInput input = sheet_and_saddle();
    input.eases.push_back(ease_along(chain, 0.1));
    return input;
  };
  EXPECT_EQ(code_thrown_by(with_ease(test::grid_column(16, 8, 4))), Code::ease_without_side) << "no outline";
  EXPECT_EQ(code_thrown_by(with_ease({0, 40})), Code::ease_without_side) << "no edge";
  EXPECT_EQ(code_thrown_by(with_ease(test::grid_column(16, 8, 0))), Code::ease_without_side) << "the other way";
  EXPECT_EQ(code_thrown_by(with_ease({-1, 0})), Code::vertex_out_of_range);
  FlattenInput twice = with_ease(seam);
  twice.eases.push_back(ease_along({seam[2], seam[3]}, 0.2));
  EXPECT_EQ(code_thrown_by(twice), Code::side_in_two_eases);
}

}  // namespace
}  // namespace wirewarp::test_ease
