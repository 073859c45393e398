// SPDX-License-Identifier: GPL-3.0-or-later
// Tests how inputs are cut into charts: seams in every arrangement, outlines, and the parts of wires between seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/planar.h"
#include "judge.h"
#include "test_meshes.h"

namespace wirewarp::test_charts {
namespace {

using test::charts_of;

long euler_characteristic(const Chart& chart) {
  return static_cast<long>(chart.mesh.n_vertices()) - static_cast<long>(chart.mesh.n_edges()) +
         static_cast<long>(chart.mesh.n_faces());
}

std::size_t outline_edges(const Chart& chart) {
  std::size_t count = 0;
  for (const BoundaryChain& chain : chart.boundary_chains) count += chain.half_edges.size();
  return count;
}

void expect_sound(const Charts& charts, const FlattenInput& input) {
  std::vector<int> seen(static_cast<std::size_t>(input.faces.rows()), 0);
  for (const Chart& chart : charts.charts) {
    for (std::size_t f = 0; f < chart.source_face.size(); ++f) {
      ++seen[static_cast<std::size_t>(chart.source_face[f])];
      HalfedgeHandle h = chart.mesh.halfedge_handle(FaceHandle(static_cast<int>(f)));
      for (int k = 0; k < 3; ++k, h = chart.mesh.next_halfedge_handle(h)) {
        const auto v = static_cast<std::size_t>(chart.mesh.from_vertex_handle(h).idx());
        EXPECT_EQ(chart.source_vertex[v], input.faces(chart.source_face[f], k));
      }
    }
    std::size_t loop_edges = 0;
    for (const HalfEdgeChain& loop : chart.boundary_loops) {
      loop_edges += loop.size();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        EXPECT_FALSE(chart.mesh.is_boundary(loop[i])) << "the chart lies on the left";
        EXPECT_EQ(chart.mesh.to_vertex_handle(loop[i]), chart.mesh.from_vertex_handle(loop[(i + 1) % loop.size()]));
      }
    }
    EXPECT_EQ(outline_edges(chart), loop_edges) << "the chains together are the loops";
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size())) << "every face in one chart";
}

TEST(Charts, ASeamAcrossMakesTwoChartsWithOneSeam) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, test::grid_column(n, n, 2));
  const Charts charts = charts_of(input);
  expect_sound(charts, input);
  ASSERT_EQ(charts.charts.size(), 2u);
  EXPECT_EQ(charts.charts[0].source_face.size(), 2u * 2 * n);
  ASSERT_EQ(charts.seams.size(), 1u);
  EXPECT_EQ(charts.seams[0].edges.size(), static_cast<std::size_t>(n));
  ASSERT_EQ(charts.seams[0].sides.size(), 2u);
  EXPECT_EQ(std::set<int>({charts.seams[0].sides[0].chart, charts.seams[0].sides[1].chart}), std::set<int>({0, 1}));
  // Each outline consists of the seam's side and one section of the rectangle's edge.
  for (const Chart& chart : charts.charts) EXPECT_EQ(chart.boundary_chains.size(), 2u);
}

TEST(Charts, ADartIsOneChartWithBothSidesOfTheSeam) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  std::vector<int> dart = test::grid_column(n, n, 3);
  dart.resize(4);  // three edges up from the lower edge
  test::add_seam(input, dart);
  const Charts charts = charts_of(input);
  expect_sound(charts, input);
  ASSERT_EQ(charts.charts.size(), 1u);
  EXPECT_EQ(euler_characteristic(charts.charts[0]), 1) << "a disk";
  ASSERT_EQ(charts.seams.size(), 1u);
  ASSERT_EQ(charts.seams[0].sides.size(), 2u);
  EXPECT_EQ(charts.seams[0].sides[0].chart, 0);
  EXPECT_EQ(charts.seams[0].sides[1].chart, 0);
  EXPECT_NE(charts.seams[0].sides[0].boundary_chain, charts.seams[0].sides[1].boundary_chain);
  EXPECT_EQ(outline_edges(charts.charts[0]), static_cast<std::size_t>(4 * n + 2 * 3));
}

TEST(Charts, ASeamInsideAChartIsASlit) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  const std::vector<int> column = test::grid_column(n, n, 3);
  test::add_seam(input, {column[2], column[3], column[4]});
  const Charts charts = charts_of(input);
  expect_sound(charts, input);
  ASSERT_EQ(charts.charts.size(), 1u);
  EXPECT_EQ(charts.charts[0].boundary_loops.size(), 2u);
  EXPECT_EQ(charts.charts[0].boundary_loops[0].size(), static_cast<std::size_t>(4 * n)) << "the outer loop first";
}

TEST(Charts, ASeamThatClosesOnItselfCutsOutADisk) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, test::grid_square(n, 3, 3, 1));
  const Charts charts = charts_of(input);
  expect_sound(charts, input);
  ASSERT_EQ(charts.charts.size(), 2u);
  ASSERT_EQ(charts.seams.size(), 1u) << "one chain without a junction";
  EXPECT_EQ(charts.seams[0].edges.size(), 8u);
  EXPECT_EQ(charts.charts[0].boundary_loops.size(), 2u);
  EXPECT_EQ(charts.charts[1].boundary_loops.size(), 1u);
}

TEST(Charts, FiveFacesOnASeamEdgeMakeFiveSides) {
  const FlattenInput input = test::book(5, 3);
  const Charts charts = charts_of(input);
  expect_sound(charts, input);
  ASSERT_EQ(charts.charts.size(), 5u);
  ASSERT_EQ(charts.seams.size(), 1u);
  std::set<int> pieces;
  for (const Seam::Side& side : charts.seams[0].sides) pieces.insert(side.chart);
  EXPECT_EQ(pieces.size(), 5u);
}

TEST(Charts, TheOuterLoopTurnsLeftEvenIfAHoleIsLonger) {
  // An annulus whose hole has a wavy outline, longer than the outer loop.
  FlattenInput input = test::flat_annulus(96, 4, 1, 2);
  for (int v = 0; v < input.vertices.rows(); ++v) {
    const double angle = std::atan2(input.vertices(v, 1), input.vertices(v, 0));
    const double inward = 2 - std::hypot(input.vertices(v, 0), input.vertices(v, 1));
    input.vertices.row(v) *= 1 + 0.35 * inward * std::cos(24 * angle);
  }
  const Chart chart = test::chart_of(input);
  ASSERT_EQ(chart.boundary_loops.size(), 2u);
  const HalfedgeHandle h = chart.boundary_loops[0][0];
  EXPECT_NEAR(chart.mesh.point(chart.mesh.from_vertex_handle(h)).norm(), 2, 1e-9);
}

TEST(Charts, AWireAcrossASeamHasAPartOnEachSide) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, test::grid_column(n, n, 2));
  test::add_wire(input, test::grid_row(n, 3), 0.05, "bust");
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts[0].wire_parts.size(), 1u);
  ASSERT_EQ(charts.charts[1].wire_parts.size(), 1u);
  EXPECT_EQ(charts.charts[0].wire_parts[0].part, 0);
  EXPECT_EQ(charts.charts[1].wire_parts[0].part, 1);
  EXPECT_EQ(charts.charts[0].wire_parts[0].half_edges.size(), 2u);
  EXPECT_EQ(charts.charts[1].wire_parts[0].half_edges.size(), 4u);
  EXPECT_EQ(charts.charts[1].wire_parts[0].kind, WireKind::elastic);
}

TEST(Charts, AWireThroughTheTipOfADartIsCutThere) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  std::vector<int> dart = test::grid_column(n, n, 3);
  dart.resize(4);
  test::add_seam(input, dart);
  test::add_wire(input, test::grid_row(n, 3));  // through the tip
  test::add_wire(input, test::grid_row(n, 2));  // across the dart
  const Chart chart = test::chart_of(input);
  EXPECT_EQ(chart.wire_parts.size(), 4u);
}

TEST(Charts, AWireAlongTheOutlineIsABoundaryPart) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_seam(input, test::grid_column(n, n, 2));
  std::vector<int> wire = test::grid_column(n, n, 2);
  wire.resize(4);
  for (int i = 3; i <= n; ++i) wire.push_back(i + (n + 1) * 3);  // three edges up the seam, then across to the right
  test::add_wire(input, wire, 0.1);
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts[0].wire_parts.size(), 1u);
  EXPECT_EQ(charts.charts[0].wire_parts[0].kind, WireKind::boundary);
  EXPECT_EQ(charts.charts[0].wire_parts[0].tolerance, 0.1);
  ASSERT_EQ(charts.charts[1].wire_parts.size(), 2u);
  EXPECT_EQ(charts.charts[1].wire_parts[0].kind, WireKind::boundary);
  EXPECT_EQ(charts.charts[1].wire_parts[0].part, 0);
  EXPECT_EQ(charts.charts[1].wire_parts[1].kind, WireKind::elastic);
  EXPECT_EQ(charts.charts[1].wire_parts[1].part, 1);
  for (const Chart& chart : charts.charts) {
    for (const WirePart& part : chart.wire_parts) {
      for (std::size_t i = 0; i + 1 < part.half_edges.size(); ++i) {
        EXPECT_EQ(chart.mesh.to_vertex_handle(part.half_edges[i]),
                  chart.mesh.from_vertex_handle(part.half_edges[i + 1]));
      }
    }
  }
}

/// Two flat disks of six triangles, one level and one upright, that share vertex 0 as their center. Their rims are
/// vertices 1 to 6 and 7 to 12.
FlattenInput disks_that_touch() {
  FlattenInput input;
  input.vertices.setZero(13, 3);
  input.faces.resize(12, 3);
  for (int i = 0; i < 6; ++i) {
    const double angle = 2 * kPi * i / 6;
    input.vertices.row(1 + i) << std::cos(angle), std::sin(angle), 0;
    input.vertices.row(7 + i) << 0, std::cos(angle), std::sin(angle);
    input.faces.row(i) << 0, 1 + i, 1 + (i + 1) % 6;
    input.faces.row(6 + i) << 0, 7 + i, 7 + (i + 1) % 6;
  }
  return input;
}

TEST(Charts, ChartsThatShareOnlyAVertexAreFlattenedSeparately) {
  const FlattenInput triangles =
      test::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 4}});
  for (const FlattenInput& input : {triangles, disks_that_touch()}) {
    const FlattenResult result = flatten(input);
    ASSERT_EQ(result.pieces.size(), 2u);
    for (const Piece& piece : result.pieces) EXPECT_FALSE(piece.error) << piece.error->what();
    EXPECT_EQ(test::broken_guarantees(input, {}, result), std::vector<std::string>{});
    expect_sound(charts_of(input), input);
  }
}

TEST(Charts, AWireThroughThePointWhereChartsTouchHasAPartInEach) {
  for (const double tolerance : {0.0, 0.1}) {
    for (const std::vector<int>& chain : {std::vector<int>{2, 0, 9}, std::vector<int>{0, 9, 8, 0, 2, 3, 0}}) {
      FlattenInput input = disks_that_touch();
      test::add_wire(input, chain, tolerance);
      std::multiset<VertexPair> expected, found;
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        expected.insert({std::min(chain[i], chain[i + 1]), std::max(chain[i], chain[i + 1])});
      }
      for (const Chart& chart : charts_of(input).charts) {
        EXPECT_EQ(chart.wire_parts.size(), chain.size() > 3 ? 3u : 1u);
        for (const WirePart& part : chart.wire_parts) {
          for (const HalfedgeHandle h : part.half_edges) found.insert(source_edge(chart, h));
        }
      }
      EXPECT_EQ(found, expected);
      const FlattenResult result = flatten(input);
      EXPECT_EQ(test::broken_guarantees(input, {}, result), std::vector<std::string>{});
      EXPECT_NEAR(result.wires.at(0).length_2d, static_cast<double>(chain.size() - 1), 1e-8);  // edges of length 1
    }
  }
}

TEST(Charts, PartsOfAClosedWirePartlyAlongTheOutlineDoNotDependOnWhereItsListBegins) {
  const int n = 6;
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  std::vector<int> ring;  // a closed wire along the lower edge from column 1 to 5, and back at height 3
  for (int i = 1; i < 5; ++i) ring.push_back(vertex(i, 0));
  for (int j = 0; j < 3; ++j) ring.push_back(vertex(5, j));
  for (int i = 5; i > 1; --i) ring.push_back(vertex(i, 3));
  for (int j = 3; j > 0; --j) ring.push_back(vertex(1, j));
  for (std::size_t turn = 0; turn < ring.size(); ++turn) {
    std::vector<int> chain = ring;
    std::rotate(chain.begin(), chain.begin() + static_cast<long>(turn), chain.end());
    chain.push_back(chain.front());
    FlattenInput input = test::flat_rectangle(n, n, 1, 1);
    test::add_wire(input, chain, 0.05);
    const Chart chart = test::chart_of(input);
    const std::vector<WirePart>& parts = chart.wire_parts;
    ASSERT_EQ(parts.size(), 2u) << turn;
    EXPECT_EQ(parts[0].kind, WireKind::boundary);
    EXPECT_EQ(parts[0].half_edges.size(), 4u);
    EXPECT_EQ(parts[1].kind, WireKind::elastic);
    EXPECT_EQ(parts[1].half_edges.size(), 10u);
  }
}

}  // namespace
}  // namespace wirewarp::test_charts
