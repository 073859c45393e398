// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/planar.h"
#include "result/lengths.h"
#include "test_meshes.h"

namespace wirewarp::test_lengths {
namespace {

using test::charts_of;
using test::planar_positions;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns a piece with measured lengths for a layout and the variation of its parts.
Piece measured_piece(const FlattenInput& input, const Chart& chart, const Positions2& uv,
                     const std::vector<double>& variation) {
  Piece piece;
  piece.vertices = uv;
  piece.wires = measure_wire_parts(chart, input.wires, uv, variation);
  piece.boundaries = measure_boundaries(chart, uv, fit_variation(chart, uv));
  return piece;
}

Piece measured_piece(const FlattenInput& input, const Chart& chart, const Positions2& uv) {
  return measured_piece(input, chart, uv, std::vector<double>(chart.wire_parts.size(), 0));
}

/// Returns a sheet of 6 by 2, cut into two pieces of 3 by 2, with a wire across both pieces at half height.
FlattenInput two_sheets(double tolerance) {
  FlattenInput input = test::flat_rectangle(6, 4, 6, 2);
  test::add_seam(input, test::grid_column(6, 4, 3));
  test::add_wire(input, test::grid_row(6, 2), tolerance, "waist");
  return input;
}

TEST(Lengths, PartsOfAWireAndTheWhole) {
  const FlattenInput input = two_sheets(0.05);
  const Charts charts = charts_of(input);
  const Chart& left = charts.charts[0];
  const Chart& right = charts.charts[1];
  Positions2 uv = planar_positions(right);
  uv.col(0) *= 1.04;
  const std::vector<Piece> pieces = {measured_piece(input, left, planar_positions(left)),
                                     measured_piece(input, right, uv, {0.03})};

  const WireReport& part = pieces[1].wires.at(0);
  EXPECT_EQ(part.name, "waist");
  EXPECT_EQ(part.wire_index, 0);
  EXPECT_EQ(part.part, 1);
  EXPECT_EQ(part.kind, WireKind::elastic);
  EXPECT_EQ(part.tolerance, 0.05);
  EXPECT_NEAR(part.length_3d, 3, 1e-14);
  EXPECT_NEAR(part.length_2d, 3 * 1.04, 1e-14);
  EXPECT_EQ(part.variation, 0.03);
  EXPECT_NEAR(part.max_edge_error, 0.01, 1e-14);  // 1.04 times the length instead of 1.03 times

  const WireReport whole = measure_whole_wires(input, charts, pieces).at(0);
  EXPECT_EQ(whole.name, "waist");
  EXPECT_EQ(whole.wire_index, 0);
  EXPECT_EQ(whole.part, -1);
  EXPECT_NEAR(whole.length_3d, 6, 1e-14);
  EXPECT_NEAR(whole.length_2d, 3 + 3 * 1.04, 1e-14);
  EXPECT_NEAR(whole.variation, (3 * 0.00 + 3 * 0.03) / 6, 1e-14);
  EXPECT_NEAR(whole.max_edge_error, 0.01, 1e-14);
}

TEST(Lengths, WholeWireIsUnknownIfAPieceHasNoLayout) {
  const FlattenInput input = two_sheets(0);
  const Charts charts = charts_of(input);
  const std::vector<Piece> pieces = {measured_piece(input, charts.charts[0], planar_positions(charts.charts[0])),
                                     Piece()};
  const WireReport whole = measure_whole_wires(input, charts, pieces).at(0);
  EXPECT_NEAR(whole.length_3d, 6, 1e-14);
  EXPECT_TRUE(std::isnan(whole.length_2d));
  EXPECT_TRUE(std::isnan(whole.variation));
  EXPECT_TRUE(std::isnan(whole.max_edge_error));

  const SeamReport seam = measure_seams(input, charts, pieces).at(0);
  ASSERT_EQ(seam.length_2d.size(), 2u);
  EXPECT_NEAR(seam.length_2d[0], 2, 1e-14);
  EXPECT_TRUE(std::isnan(seam.length_2d[1]));
  EXPECT_TRUE(std::isnan(seam.mismatch));
}

TEST(Lengths, WireAlongASeamCountsOnce) {
  FlattenInput input = test::flat_rectangle(6, 4, 6, 2);
  test::add_seam(input, test::grid_column(6, 4, 3));
  test::add_wire(input, test::grid_column(6, 4, 3), 0.1, "side");
  const Charts charts = charts_of(input);
  std::vector<Piece> pieces;
  for (const Chart& chart : charts.charts) {
    pieces.push_back(measured_piece(input, chart, planar_positions(chart)));
    ASSERT_EQ(pieces.back().wires.size(), 1u);
    EXPECT_EQ(pieces.back().wires[0].kind, WireKind::boundary);
    EXPECT_EQ(pieces.back().wires[0].tolerance, 0.1);
  }
  const WireReport whole = measure_whole_wires(input, charts, pieces).at(0);
  EXPECT_NEAR(whole.length_3d, 2, 1e-14);
  EXPECT_NEAR(whole.length_2d, 2, 1e-14);
  EXPECT_EQ(whole.kind, WireKind::boundary);
  EXPECT_EQ(whole.tolerance, 0.1);
}

TEST(Lengths, SeamSidesAndTheirMismatch) {
  const FlattenInput input = two_sheets(0);
  const Charts charts = charts_of(input);
  Positions2 uv = planar_positions(charts.charts[1]);
  uv.col(1) *= 1.25;
  const std::vector<Piece> pieces = {measured_piece(input, charts.charts[0], planar_positions(charts.charts[0])),
                                     measured_piece(input, charts.charts[1], uv)};
  const std::vector<SeamReport> seams = measure_seams(input, charts, pieces);
  ASSERT_EQ(seams.size(), 1u);
  EXPECT_EQ(seams[0].edges.size(), 4u);
  EXPECT_EQ(seams[0].pieces, (std::vector<int>{0, 1}));
  EXPECT_NEAR(seams[0].length_3d, 2, 1e-14);
  EXPECT_NEAR(seams[0].length_2d[0], 2, 1e-14);
  EXPECT_NEAR(seams[0].length_2d[1], 2 * 1.25, 1e-14);
  EXPECT_NEAR(seams[0].mismatch, 0.5, 1e-14);

  // The section of the outline along the seam is as long as the side of the seam.
  for (const BoundaryReport& boundary : pieces[1].boundaries) {
    if (!boundary.seam) continue;
    EXPECT_EQ(*boundary.seam, 0);
    EXPECT_EQ(boundary.vertices.size(), 5u);
    EXPECT_NEAR(boundary.length_2d, 2 * 1.25, 1e-14);
    EXPECT_NEAR(boundary.max_edge_error, 0.25, 1e-14);
  }
}

TEST(Lengths, OutlineOfAnAnnulusIsTwoClosedChains) {
  const Chart chart = test::chart_of(test::flat_annulus(12, 1, 1, 2));
  const std::vector<BoundaryReport> reports = measure_boundaries(chart, planar_positions(chart), {});
  ASSERT_EQ(reports.size(), 2u);
  for (const BoundaryReport& report : reports) {
    EXPECT_EQ(report.vertices.size(), 13u);
    EXPECT_EQ(report.vertices.front(), report.vertices.back());
    EXPECT_FALSE(report.seam);
  }
  const double sides = 12 * 2 * std::sin(kPi / 12);
  EXPECT_NEAR(reports[0].length_2d, 2 * sides, 1e-13);
  EXPECT_NEAR(reports[1].length_2d, 1 * sides, 1e-13);
}

TEST(Lengths, FittedVariationStaysWithinTheTolerance) {
  for (const auto& [tolerance, expected] :
       {std::pair(0.0, 0.0), std::pair(0.05, 0.05), std::pair(0.2, 0.1), std::pair(kInfinity, 0.1)}) {
    FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
    test::add_wire(input, test::grid_row(4, 2), tolerance);
    const Chart chart = test::chart_of(input);
    Positions2 uv = planar_positions(chart);
    uv.col(0) *= 1.1;
    const std::vector<double> variation = fit_variation(chart, uv);
    ASSERT_EQ(variation.size(), 1u);
    EXPECT_NEAR(variation[0], expected, 1e-14);
  }
}

}  // namespace
}  // namespace wirewarp::test_lengths
