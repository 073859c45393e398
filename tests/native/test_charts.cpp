// SPDX-License-Identifier: GPL-3.0-or-later
// Tests how inputs are cut into charts, wires into parts between seams, and charts into patches between wires.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include "base/planar.h"
#include "error_of.h"
#include "surface/network/wire_lines.h"
#include "surface/network/wire_network.h"
#include "test_meshes.h"

namespace wirewarp::test_charts {
namespace {

using test::charts_of;
using test::section;

/// Returns a text such as "24 faces around 16, elastic part 0 of 2; 6 edges between 0 1":
/// - a chart of 24 faces, an outline of 16 edges, and part 0 of an elastic wire, with 2 edges
/// - a seam of 6 edges between charts 0 and 1
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
  std::vector<int> seen(input.faces.rows(), 0);
  for (const Chart& chart : charts.charts) {
    for (std::size_t f = 0; f < chart.source_face.size(); ++f) {
      ++seen[chart.source_face[f]];
      HalfedgeHandle h = chart.mesh.halfedge_handle(FaceHandle(static_cast<int>(f)));
      for (int k = 0; k < 3; ++k, h = chart.mesh.next_halfedge_handle(h)) {
        const int v = chart.mesh.from_vertex_handle(h).idx();
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

constexpr int kN = 6;

FlattenInput sheet(const std::vector<int>& seam, const std::vector<std::vector<int>>& wires = {}) {
  FlattenInput input = test::flat_rectangle(kN, kN, 1, 1);
  test::add_seam(input, seam);
  for (const std::vector<int>& wire : wires) test::add_wire(input, wire, 0.1);
  return input;
}

TEST(Charts, HaveTheirFacesLoopsSeamsAndPartsOfWires) {
  const std::vector<int> column = test::grid_column(kN, kN, 2), row = test::grid_row(kN, 3);
  std::vector<int> up_and_right = section(column, 0, 3);  // up along the seam, then along the row to the right
  up_and_right.insert(up_and_right.end(), row.begin() + 3, row.end());
  const std::vector<std::pair<FlattenInput, std::string>> cases = {
      {sheet(column), "24 faces around 16; 48 faces around 20; 6 edges between 0 1"},
      {sheet(section(column, 0, 3)), "72 faces around 30; 3 edges between 0 0"},    // a dart
      {sheet(section(column, 2, 4)), "72 faces around 24 4; 2 edges between 0 0"},  // a slit, whose loop is the second
      {sheet(test::grid_square(kN, 3, 3, 1)), "64 faces around 24 8; 8 faces around 8; 8 edges between 0 1"},
      {sheet(column, {row}),
       "24 faces around 16, elastic part 0 of 2; 48 faces around 20, elastic part 1 of 4; 6 edges between 0 1"},
      // One wire leads through the tip of a dart, and one wire across the dart.
      {sheet(section(column, 0, 3), {row, test::grid_row(kN, 2)}),
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
  // An annulus with a hole whose wavy outline is longer than the outer loop.
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
    EXPECT_EQ(result.pieces.size(), 2u);
    test::expect_good(input, result);
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
      test::expect_good(input, result);
      EXPECT_NEAR(result.wires.at(0).length_2d, static_cast<double>(chain.size() - 1), 1e-8);  // edges of length 1
    }
  }
}

TEST(Charts, PartsOfAClosedWirePartlyAlongTheOutlineDoNotDependOnWhereItsListBegins) {
  const auto vertex = [](int i, int j) { return i + (kN + 1) * j; };
  std::vector<int> ring;  // a closed wire along the lower edge from column 1 to 5, and back at height 3
  for (int i = 1; i < 5; ++i) ring.push_back(vertex(i, 0));
  for (int j = 0; j < 3; ++j) ring.push_back(vertex(5, j));
  for (int i = 5; i > 1; --i) ring.push_back(vertex(i, 3));
  for (int j = 3; j > 0; --j) ring.push_back(vertex(1, j));
  for (std::size_t turn = 0; turn < ring.size(); ++turn) {
    std::vector<int> chain = ring;
    std::rotate(chain.begin(), chain.begin() + static_cast<long>(turn), chain.end());
    chain.push_back(chain.front());
    FlattenInput input = test::flat_rectangle(kN, kN, 1, 1);
    test::add_wire(input, chain, 0.05);
    EXPECT_EQ(described(charts_of(input)), "72 faces around 24, outline part 0 of 4, elastic part 1 of 10") << turn;
  }
}

struct Network {
  explicit Network(const FlattenInput& input) : chart(test::chart_of(input)), network(build_wire_network(chart)) {}
  Chart chart;
  WireNetwork network;
};

std::size_t num_loop_nodes(const WireNetwork& network) {
  std::size_t count = 0;
  for (const WirePatch& patch : network.patches) {
    for (const auto& loop : patch.loops) count += loop.size();
  }
  return count;
}

void expect_closed_walks(const WireNetwork& network) {
  EXPECT_EQ(num_loop_nodes(network), network.nodes.size()) << "every node in one loop";
  for (const WirePatch& patch : network.patches) {
    for (const auto& loop : patch.loops) {
      for (std::size_t b = 0; b < loop.size(); ++b) {
        const WireNode& node = network.nodes[loop[b].node];
        const WireHalfEdge before = loop[(b + loop.size() - 1) % loop.size()].half_edge;
        EXPECT_EQ(node.in.edge, before.edge);
        EXPECT_EQ(node.in.reversed, before.reversed);
        EXPECT_EQ(node.out.edge, loop[b].half_edge.edge);
      }
    }
  }
}

TEST(WireNetwork, CrossingWiresMakeFourPatchesAndFourNodesWhereTheyCross) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_wire(input, test::grid_row(n, 3));
  test::add_wire(input, test::grid_column(n, n, 2));
  const Network p(input);
  expect_closed_walks(p.network);
  EXPECT_EQ(p.network.patches.size(), 4u);
  EXPECT_EQ(p.network.edges.size(), static_cast<std::size_t>(4 * n + 2 * n));
  // Each boundary vertex has one node, or two if a wire ends there. Inner vertices of wires have two nodes, and the
  // crossing has four nodes.
  EXPECT_EQ(p.network.nodes.size(), static_cast<std::size_t>(4 * n + 4 + 2 * (2 * n - 3) - 2 + 4));
  std::size_t most = 0;
  for (const auto& nodes : p.network.inner_vertex_nodes) most = std::max(most, nodes.size());
  EXPECT_EQ(most, 4u);
}

TEST(WireNetwork, GaussBonnet) {
  // On every disk, the turning of the outline and the angle deficits inside add up to 2π.
  const Network p(test::quarter_sphere(8));
  const HalfEdgeMesh& mesh = p.chart.mesh;
  double sum = 0;
  std::vector<double> node_angle(mesh.n_vertices(), 0);
  for (const WireNode& node : p.network.nodes) node_angle[node.vertex.idx()] += node.surface_angle;
  for (const HalfedgeHandle h : p.chart.boundary_loops[0]) {
    sum += kPi - node_angle[mesh.from_vertex_handle(h).idx()];
  }
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_boundary(v)) continue;
    sum += 2 * kPi;
    for (const HalfedgeHandle h : mesh.voh_range(v)) {
      const auto along = mesh.point(mesh.to_vertex_handle(h)) - mesh.point(v);
      const auto next = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))) - mesh.point(v);
      sum -= std::acos((along | next) / (along.norm() * next.norm()));
    }
  }
  EXPECT_NEAR(sum, 2 * kPi, 1e-11);
}

TEST(WireNetwork, ATailHasOneNodeAndAHoleItsOwnLoop) {
  const int n = 6;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_wire(input, test::section(test::grid_row(n, 3), 0, 3));
  const Network tail(input);
  expect_closed_walks(tail.network);
  EXPECT_EQ(std::count_if(tail.network.nodes.begin(), tail.network.nodes.end(),
                          [](const WireNode& node) { return node.is_tail; }),
            1);

  const Network annulus(test::flat_annulus(12, 2, 1, 2));
  expect_closed_walks(annulus.network);
  ASSERT_EQ(annulus.network.patches.size(), 1u);
  EXPECT_EQ(annulus.network.patches[0].loops.size(), 2u);
  ASSERT_EQ(annulus.network.holes.size(), 1u);
  EXPECT_EQ(annulus.network.holes[0].size(), 12u);
}

std::size_t bends_past_corners(const WireLines& lines) {
  return static_cast<std::size_t>(
      std::count_if(lines.bends.begin(), lines.bends.end(), [](const LineBend& bend) { return bend.num_sectors > 1; }));
}

TEST(WireLines, ContinueThroughCrossingsAndWhereWiresMeetTheOutline) {
  FlattenInput input = test::flat_rectangle(6, 6, 1, 1);
  test::add_wire(input, test::grid_row(6, 3));
  test::add_wire(input, test::grid_column(6, 6, 2));
  const Network crossed(input);
  const WireLines lines = find_lines(crossed.chart, crossed.network);
  EXPECT_EQ(lines.corners.size(), 4u + 4u * 2u);
  EXPECT_EQ(lines.bends.size(), 24u + 2u * 2u * 5u)
      << "one bend at each outline vertex, two at each inner vertex of a wire";
  EXPECT_EQ(bends_past_corners(lines), 4u + 4u);
  for (const LineBend& bend : lines.bends) {
    const bool is_corner_of_square = std::abs(bend.node.surface_angle - kPi / 2) < 1e-12;
    EXPECT_TRUE(is_corner_of_square || std::abs(bend.node.surface_angle - kPi) < 1e-12) << bend.node.surface_angle;
  }
}

TEST(WireLines, TwoWiresEndToEndAreOneLineUnlessAThirdWireMeetsThem) {
  FlattenInput input = test::flat_rectangle(6, 6, 1, 1);
  test::add_wire(input, test::section(test::grid_row(6, 3), 0, 3));
  test::add_wire(input, test::section(test::grid_row(6, 3), 3, 6));
  const Network joined(input);
  EXPECT_EQ(find_lines(joined.chart, joined.network).corners.size(), 2u * 2u) << "only where they meet the outline";
  test::add_wire(input, test::section(test::grid_column(6, 6, 3), 0, 3));
  const Network met(input);
  EXPECT_EQ(find_lines(met.chart, met.network).corners.size(), 3u * 2u + 3u);
}

}  // namespace
}  // namespace wirewarp::test_charts
