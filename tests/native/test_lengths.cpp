// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of measured lengths, of measure() with flattenings by other programs, and of the check of the guarantees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/planar.h"
#include "error_of.h"
#include "result/guarantee.h"
#include "result/lengths.h"
#include "result/metrics.h"
#include "test_meshes.h"

namespace wirewarp::test_lengths {
namespace {

using test::charts_of;
using test::planar_positions;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

FlattenInput two_sheets(double tolerance) {
  FlattenInput input = test::flat_rectangle(6, 4, 6, 2);
  test::add_seam(input, test::grid_column(6, 4, 3));
  test::add_wire(input, test::grid_row(6, 2), tolerance, "waist");
  return input;
}

TEST(Lengths, PartsOfAWireAndTheWhole) {
  const FlattenInput input = two_sheets(0.05);
  const Charts charts = charts_of(input);
  const Chart &left = charts.charts[0], &right = charts.charts[1];
  Positions2 uv = planar_positions(right);
  uv.col(0) *= 1.04;
  const std::vector<Piece> pieces = {measured_piece(input, left, planar_positions(left)),
                                     measured_piece(input, right, uv, {0.03})};

  const WireReport& part = pieces[1].wires.at(0);
  const WireReport whole = measure_whole_wires(input, charts, pieces).at(0);
  for (const WireReport& wire : {part, whole}) {
    EXPECT_EQ(wire.name, "waist");
    EXPECT_EQ(wire.wire_index, 0);
    EXPECT_NEAR(wire.max_edge_error, 0.01, 1e-14);  // 1.04 times the length instead of 1.03 times
  }
  EXPECT_EQ(part.part, 1);
  EXPECT_EQ(part.kind, WireKind::elastic);
  EXPECT_EQ(part.tolerance, 0.05);
  EXPECT_NEAR(part.length_3d, 3, 1e-14);
  EXPECT_NEAR(part.length_2d, 3 * 1.04, 1e-14);
  EXPECT_EQ(part.variation, 0.03);

  EXPECT_EQ(whole.part, -1);
  EXPECT_NEAR(whole.length_3d, 6, 1e-14);
  EXPECT_NEAR(whole.length_2d, 3 + 3 * 1.04, 1e-14);
  EXPECT_NEAR(whole.variation, (3 * 0.00 + 3 * 0.03) / 6, 1e-14);
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

TEST(Measure, ATornFlatteningIsRefused) {
  // In the upper half of a square, the corners on the middle row are moved by 0.02, except at the ends of the row.
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  CornerUv torn(input.faces.rows(), 6);
  for (int f = 0; f < input.faces.rows(); ++f) {
    const bool is_above = f >= input.faces.rows() / 2;
    for (int k = 0; k < 3; ++k) {
      const int v = input.faces(f, k);
      torn.block<1, 2>(f, 2 * k) = input.vertices.row(v).head<2>();
      if (is_above && v > 10 && v < 14) torn(f, 2 * k) += 0.02;
    }
  }
  for (const Eigen::RowVector2d& offset : {Eigen::RowVector2d(0, 0), Eigen::RowVector2d(1e5, 0)}) {
    CornerUv moved = torn;
    for (int k = 0; k < 3; ++k) moved.middleCols<2>(2 * k).rowwise() += offset;
    const FlattenError error = test::expect_error(measure(input, moved).pieces[0].error, ErrorCode::uv_discontinuous);
    EXPECT_EQ(error.elements.vertices, (std::vector<int>{11, 12, 13}));
    EXPECT_EQ(error.elements.edges, (std::vector<VertexPair>{{10, 11}, {11, 12}, {12, 13}, {13, 14}}));
  }
}

TEST(Measure, RoundedCornersAreNotATear) {
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  CornerUv corners = flatten(input).corner_uv;
  for (int i = 0; i < corners.size(); ++i) corners.data()[i] += (i / 6 % 2 == 0 ? 1e-9 : -1e-9);
  const FlattenResult result = measure(input, corners);
  EXPECT_NE(result.pieces[0].error.value_or(FlattenError(ErrorCode::cancelled, "")).code, ErrorCode::uv_discontinuous);
}

TEST(Measure, ReportsTimesAndThatNothingWasSolved) {
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  const FlattenResult result = measure(input, flatten(input).corner_uv);
  EXPECT_GE(result.seconds.at("total"), result.seconds.at("charts") + result.seconds.at("measure"));
  EXPECT_EQ(result.pieces[0].report.termination, Termination::measured);
  EXPECT_TRUE(std::isnan(result.pieces[0].report.constraint_residual));
}

TEST(Measure, AFlatteningWithMissingCoordinatesIsRefused) {
  const FlattenInput input = test::flat_rectangle(2, 2, 1, 1);
  CornerUv corners = flatten(input).corner_uv;
  for (const double bad : {std::nan(""), 1e200}) {
    corners(3, 2) = bad;
    const FlattenError error = test::expect_error(measure(input, corners).pieces[0].error, ErrorCode::no_layout);
    EXPECT_EQ(error.elements.faces, std::vector<int>{3});
  }
}

/// A unit square with a wire across at half height, from vertex 10 to vertex 14. Vertex 12 is the middle of the wire.
struct Sheet {
  FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  Chart chart;
  WireNetwork network;
  Positions2 uv;
  std::vector<double> variation;

  explicit Sheet(double tolerance) {
    test::add_wire(input, test::grid_row(4, 2), tolerance, "waist");
    chart = test::chart_of(input);
    network = build_wire_network(chart);
    uv = planar_positions(chart);
    variation.assign(chart.wire_parts.size(), 0);
  }

  std::optional<FlattenError> check() const {
    return check_guarantee(chart, network, input.wires, uv, variation, measure_metrics(chart, network, uv), {});
  }
};

TEST(Guarantee, LengthErrorsAboveOnePartInABillionAreReported) {
  Sheet sheet(0);
  sheet.uv(12, 0) += 0.25 * 0.9e-9;  // edges are 0.25 long
  EXPECT_FALSE(sheet.check());
  sheet.uv(12, 0) += 0.25 * 0.3e-9;
  const FlattenError error = test::expect_error(sheet.check(), ErrorCode::lengths_not_kept);
  EXPECT_TRUE(error.has_layout);
  EXPECT_EQ(error.elements.edges, (std::vector<VertexPair>{{11, 12}, {12, 13}}));
  test::expect_words(error, "11-12");
  test::expect_words(error, "waist");
}

TEST(Guarantee, RoundingOfFarAwayCoordinatesIsNoError) {
  Sheet sheet(0);
  sheet.uv.array() += 1e8;  // with rounding errors of 1.5e-8
  EXPECT_FALSE(sheet.check());
}

TEST(Guarantee, OutlinesAreRigidAndFreeWiresAreNotChecked) {
  Sheet sheet(std::numeric_limits<double>::infinity());
  sheet.uv(12, 0) += 0.1;
  EXPECT_FALSE(sheet.check());
  sheet.uv(0, 0) -= 0.01;
  const FlattenError error = test::expect_error(sheet.check(), ErrorCode::lengths_not_kept);
  test::expect_words(error, "outline");
  EXPECT_EQ(error.elements.edges.size(), 2u);
}

TEST(Guarantee, ElasticEdgesFollowTheirVariation) {
  Sheet sheet(0.05);
  const double h = 0.01;
  // A zigzag between the fixed ends of the wire makes each edge of the wire longer by the fraction h.
  const double rise = 0.25 * std::sqrt((1 + h) * (1 + h) - 1);
  sheet.uv(11, 1) += rise;
  sheet.uv(13, 1) += rise;
  EXPECT_EQ(test::expect_error(sheet.check(), ErrorCode::lengths_not_kept).elements.edges.size(), 4u);
  sheet.variation[0] = h;
  EXPECT_FALSE(sheet.check());
}

TEST(Guarantee, VariationBeyondTheToleranceIsAnError) {
  Sheet sheet(0.05);
  sheet.variation[0] = 0.06;
  for (int i = 0; i <= 4; ++i) sheet.uv(10 + i, 0) *= 1.06;
  const FlattenError error = test::expect_error(sheet.check(), ErrorCode::lengths_not_kept);
  for (int i = 0; i < 4; ++i) {
    const VertexPair edge = {10 + i, 11 + i};
    EXPECT_NE(std::find(error.elements.edges.begin(), error.elements.edges.end(), edge), error.elements.edges.end());
  }
}

TEST(Guarantee, FlippedFacesAreNamed) {
  Sheet sheet(std::numeric_limits<double>::infinity());
  sheet.uv.row(6) << 0.6, 0.3;  // an inner vertex that is not on the wire moves past its right neighbor
  const FlattenError error = test::expect_error(sheet.check(), ErrorCode::flipped_faces);
  EXPECT_TRUE(error.has_layout);
  EXPECT_FALSE(error.elements.faces.empty());
  test::expect_words(error, std::to_string(error.elements.faces[0]));
}

TEST(Guarantee, LengthsAreReportedFirstAndOtherFaultsAreMentioned) {
  Sheet sheet(0);
  sheet.uv.row(12) << 0.9, 0.9;
  const FlattenError error = test::expect_error(sheet.check(), ErrorCode::lengths_not_kept);
  test::expect_words(error, "flipped");
  test::expect_words(error, "overlaps");
  test::expect_words(error, "give its wires more tolerance");
}

TEST(Guarantee, NoAdviceOnWiresIfThereAreNone) {
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  const Chart chart = test::chart_of(input);
  const WireNetwork network = build_wire_network(chart);
  for (const int moved : {0, 6}) {  // moves a corner of the outline, then a vertex inside
    Positions2 uv = planar_positions(chart);
    uv.row(moved) << 0.6, 0.6;
    const Metrics metrics = measure_metrics(chart, network, uv);
    const FlattenError error = test::expect_error(check_guarantee(chart, network, {}, uv, {}, metrics, {}),
                                                  moved == 0 ? ErrorCode::lengths_not_kept : ErrorCode::flipped_faces);
    EXPECT_EQ(std::string(error.what()).find("wire"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace wirewarp::test_lengths
