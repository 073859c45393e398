// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a ring that is flipped somewhere proposed only the seam that opens it, although a dart or a wire with
// tolerance may help.
#include <gtest/gtest.h>

#include "result/guarantee.h"
#include "result/metrics.h"
#include "test_meshes.h"

namespace wirewarp::ring_without_other_remedies_test {
namespace {

TEST(Bugs, TheErrorOfARingProposesEveryRemedy) {
  const int around = 16;
  FlattenInput input = test::flat_annulus(around, 4, 1, 3);
  const int inside = test::nearest_vertex(input, {0, 2, 0});
  const int begin = test::nearest_vertex(input, {0, -1, 0}), end = test::nearest_vertex(input, {0, -1.5, 0});
  test::add_wire(input, {begin, end}, 0, "spoke");
  const Charts charts = test::charts_of(input);
  const Chart& chart = charts.charts.at(0);
  const WireNetwork network = build_wire_network(chart);
  Positions2 uv = test::planar_positions(chart);
  uv(inside, 1) -= 0.7;  // moved onto the next ring
  const auto error = check_guarantee(chart, network, input.wires, uv, std::vector<double>(chart.wire_parts.size(), 0),
                                     measure_metrics(chart, network, uv), {{begin, end}});
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::flipped_faces);
  EXPECT_EQ(error->elements.proposed_seams, (std::vector<VertexPair>{{begin, end}}));
  for (const char* remedy :
       {"mark seams, such as along edge", "add a seam or a dart there", "remove a wire nearby or give it tolerance"}) {
    EXPECT_NE(std::string(error->what()).find(remedy), std::string::npos) << remedy << " in: " << error->what();
  }
}

}  // namespace
}  // namespace wirewarp::ring_without_other_remedies_test
