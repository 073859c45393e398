// SPDX-License-Identifier: GPL-3.0-or-later
// Tests how inputs are cut into charts: seams in every arrangement, outlines, and the parts of wires between seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include "base/planar.h"
#include "judge.h"
#include "test_meshes.h"

namespace wirewarp::test_charts {
namespace {

using test::charts_of;

/// Returns a text that lists, for each chart, its numbers of faces and of edges of each loop, and its wire parts. Then
/// the text lists, for each seam, its number of edges and the charts on its sides. Example: "24 faces around 16,
/// elastic part 0 of 2; 6 edges between 0 1".
std::string described(const Charts& charts) {
  std::ostringstream text;
  for (const Chart& chart : charts.charts) {
    text << (text.str().empty() ? "" : "; ") << chart.source_face.size() << " faces around";
    for (const HalfEdgeChain& loop : chart.boundary_loops) text << ' ' << loop.size();
    for (const WirePart& part : chart.wire_parts) {
      text << (part.kind == WireKind::boundary  ? ", outline"
               : part.kind == WireKind::elastic ? ", elastic"
                                                : ", rigid")
           << " part " << part.part << " of " << part.half_edges.size();
    }
  }
  for (const Seam& seam : charts.seams) {
    text << "; " << seam.edges.size() << " edges between";
    for (const Seam::Side& side : seam.sides) text << ' ' << side.chart;
  }
  return text.str();
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
    for (const BoundaryChain& chain : chart.boundary_chains) loop_edges -= chain.half_edges.size();
    EXPECT_EQ(loop_edges, 0u) << "the chains together are the loops";
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size())) << "every face in one chart";
}

constexpr int kN = 6;  // squares along a side of the sheet, each of two triangles

FlattenInput sheet(const std::vector<int>& seam, const std::vector<std::vector<int>>& wires = {}) {
  FlattenInput input = test::flat_rectangle(kN, kN, 1, 1);
  test::add_seam(input, seam);
  for (const std::vector<int>& wire : wires) test::add_wire(input, wire, 0.1);
  return input;
}

/// Returns the part of a line that has `edges` edges and starts with edge `begin` of the line.
std::vector<int> part_of(std::vector<int> line, std::size_t edges, std::size_t begin = 0) {
  return {line.begin() + static_cast<long>(begin), line.begin() + static_cast<long>(begin + edges + 1)};
}

TEST(Charts, HaveTheirFacesLoopsSeamsAndPartsOfWires) {
  const std::vector<int> column = test::grid_column(kN, kN, 2), row = test::grid_row(kN, 3);
  std::vector<int> up_and_right = part_of(column, 3);  // three edges up along the seam, then along the row to the right
  up_and_right.insert(up_and_right.end(), row.begin() + 3, row.end());
  const std::vector<std::pair<FlattenInput, std::string>> cases = {
      {sheet(column), "24 faces around 16; 48 faces around 20; 6 edges between 0 1"},
      {sheet(part_of(column, 3)), "72 faces around 30; 3 edges between 0 0"},       // a dart
      {sheet(part_of(column, 2, 2)), "72 faces around 24 4; 2 edges between 0 0"},  // a slit: its loop is the second
      {sheet(test::grid_square(kN, 3, 3, 1)), "64 faces around 24 8; 8 faces around 8; 8 edges between 0 1"},
      {sheet(column, {row}),
       "24 faces around 16, elastic part 0 of 2; 48 faces around 20, elastic part 1 of 4; 6 edges between 0 1"},
      // One wire leads through the tip of a dart, and one wire across the dart.
      {sheet(part_of(column, 3), {row, test::grid_row(kN, 2)}),
       "72 faces around 30, elastic part 0 of 2, elastic part 1 of 4, elastic part 0 of 2, elastic part 1 of 4; "
       "3 edges between 0 0"},
      {sheet(column, {up_and_right}),
       "24 faces around 16, outline part 0 of 3; 48 faces around 20, outline part 0 of 3, elastic part 1 of 4; "
       "6 edges between 0 1"},
  };
  for (const auto& [input, expected] : cases) {
    const Charts charts = charts_of(input);
    EXPECT_EQ(described(charts), expected);
    expect_sound(charts, input);
  }
}

TEST(Charts, FiveFacesOnASeamEdgeMakeFiveSides) {
  const FlattenInput input = test::book(5, 3);
  const Charts charts = charts_of(input);
  expect_sound(charts, input);
  ASSERT_EQ(charts.charts.size(), 5u);
  const std::string expected = "; 3 edges between 0 1 2 3 4";
  const std::string found = described(charts);
  EXPECT_EQ(found.substr(found.size() - expected.size()), expected);
}

TEST(Charts, TheOuterLoopIsFirstEvenIfAHoleIsLonger) {
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

/// Returns two flat disks of six triangles, one level and one upright, that share vertex 0 as their center. Their rims
/// are vertices 1 to 6 and 7 to 12.
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
  constexpr int n = kN;
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
    EXPECT_EQ(described(charts_of(input)), "72 faces around 24, outline part 0 of 4, elastic part 1 of 10") << turn;
  }
}

}  // namespace
}  // namespace wirewarp::test_charts
