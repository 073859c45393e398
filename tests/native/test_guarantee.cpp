// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/planar.h"
#include "error_of.h"
#include "result/guarantee.h"
#include "result/metrics.h"
#include "test_meshes.h"

namespace wirewarp::test_guarantee {
namespace {

using test::charts_of;
using test::planar_positions;

/// A unit square with a wire across at half height, from vertex 10 to vertex 14. Vertex 12 is the middle of the wire.
struct Sheet {
  FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  Charts charts;
  WireNetwork network;
  Positions2 uv;
  std::vector<double> variation;

  explicit Sheet(double tolerance) {
    test::add_wire(input, test::grid_row(4, 2), tolerance, "waist");
    charts = charts_of(input);
    network = build_wire_network(chart());
    uv = planar_positions(chart());
    variation.assign(chart().wire_parts.size(), 0);
  }

  const Chart& chart() const { return charts.charts[0]; }

  std::optional<FlattenError> check() const {
    return check_guarantee(chart(), network, input.wires, uv, variation, measure_metrics(chart(), network, uv), {});
  }
};

TEST(Guarantee, FlatSheetKeepsEveryGuarantee) { EXPECT_FALSE(Sheet(0).check()); }

TEST(Guarantee, LengthErrorsAboveOnePartInABillionAreReported) {
  Sheet sheet(0);
  sheet.uv(12, 0) += 0.25 * 0.9e-9;  // edges are 0.25 long
  EXPECT_FALSE(sheet.check());
  sheet.uv(12, 0) += 0.25 * 0.3e-9;
  const std::optional<FlattenError> error = sheet.check();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::lengths_not_kept);
  EXPECT_TRUE(error->has_layout);
  EXPECT_EQ(error->elements.edges, (std::vector<VertexPair>{{11, 12}, {12, 13}}));
  test::expect_words(*error, "11-12");
  test::expect_words(*error, "waist");
}

TEST(Guarantee, RoundingOfFarAwayCoordinatesIsNoError) {
  Sheet sheet(0);
  sheet.uv.array() += 1e8;  // with rounding errors of 1.5e-8
  EXPECT_FALSE(sheet.check());
}

TEST(Guarantee, OutlineIsRigid) {
  Sheet sheet(std::numeric_limits<double>::infinity());
  sheet.uv(0, 0) -= 0.01;
  const std::optional<FlattenError> error = sheet.check();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::lengths_not_kept);
  test::expect_words(*error, "outline");
  EXPECT_EQ(error->elements.edges.size(), 2u);
}

TEST(Guarantee, ElasticEdgesFollowTheirVariation) {
  Sheet sheet(0.05);
  const double h = 0.01;
  // A zigzag between the fixed ends of the wire makes each edge of the wire longer by the fraction h.
  const double rise = 0.25 * std::sqrt((1 + h) * (1 + h) - 1);
  sheet.uv(11, 1) += rise;
  sheet.uv(13, 1) += rise;
  const std::optional<FlattenError> error = sheet.check();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->elements.edges.size(), 4u);
  sheet.variation[0] = h;
  EXPECT_FALSE(sheet.check());
}

TEST(Guarantee, VariationBeyondTheToleranceIsAnError) {
  Sheet sheet(0.05);
  sheet.variation[0] = 0.06;
  for (int i = 0; i <= 4; ++i) sheet.uv(10 + i, 0) *= 1.06;
  const std::optional<FlattenError> error = sheet.check();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::lengths_not_kept);
  for (int i = 0; i < 4; ++i) {
    const VertexPair edge = {10 + i, 11 + i};
    EXPECT_NE(std::find(error->elements.edges.begin(), error->elements.edges.end(), edge), error->elements.edges.end());
  }
}

TEST(Guarantee, FreeWiresAreNotChecked) {
  Sheet sheet(std::numeric_limits<double>::infinity());
  sheet.uv(12, 0) += 0.1;
  EXPECT_FALSE(sheet.check());
}

TEST(Guarantee, FlippedFacesAreNamed) {
  Sheet sheet(std::numeric_limits<double>::infinity());
  sheet.uv.row(6) << 0.6, 0.3;  // an inner vertex that is not on the wire moves past its right neighbor
  const std::optional<FlattenError> error = sheet.check();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::flipped_faces);
  EXPECT_TRUE(error->has_layout);
  EXPECT_FALSE(error->elements.faces.empty());
  test::expect_words(*error, std::to_string(error->elements.faces[0]));
}

TEST(Guarantee, LengthsAreReportedFirstAndOtherFaultsAreMentioned) {
  Sheet sheet(0);
  sheet.uv.row(12) << 0.9, 0.9;
  const std::optional<FlattenError> error = sheet.check();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::lengths_not_kept);
  test::expect_words(*error, "flipped");
  test::expect_words(*error, "overlaps");
  test::expect_words(*error, "give its wires more tolerance");
}

TEST(Guarantee, NoAdviceOnWiresIfThereAreNone) {
  const FlattenInput input = test::flat_rectangle(4, 4, 1, 1);
  const Chart chart = test::chart_of(input);
  const WireNetwork network = build_wire_network(chart);
  for (const int moved : {0, 6}) {  // moves a corner of the outline, then a vertex inside
    Positions2 uv = planar_positions(chart);
    uv.row(moved) << 0.6, 0.6;
    const Metrics metrics = measure_metrics(chart, network, uv);
    const std::optional<FlattenError> error = check_guarantee(chart, network, {}, uv, {}, metrics, {});
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, moved == 0 ? ErrorCode::lengths_not_kept : ErrorCode::flipped_faces);
    EXPECT_EQ(std::string(error->what()).find("wire"), std::string::npos) << error->what();
  }
}

}  // namespace
}  // namespace wirewarp::test_guarantee
