// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of sets of seams that are smooth lines across triangles.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "closed_meshes.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/cut_progress.h"
#include "cuts/propose/flat_width.h"
#include "cuts/propose/line_evaluation.h"
#include "cuts/propose/merge_smooth.h"
#include "cuts/propose/smooth_sets.h"
#include "disguise.h"
#include "judge_cuts.h"
#include "surface/middle_surface.h"
#include "test_meshes.h"
#include "wirewarp/cloth.h"
#include "wirewarp/cut_mesh.h"

namespace wirewarp::test_smooth_sets {
namespace {

FlattenInput egg(int around, int rings) {
  const auto place = [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double nose = 1 + 0.2 * std::exp(-4 * (p - Eigen::Vector3d(1, 0, 0.3)).squaredNorm());
    return nose * Eigen::Vector3d(p[0], 0.8 * p[1], 1.3 * p[2]);
  };
  return test::closed_surface(around, rings, place, [](int i, int j) { return (i + j) % 2 == 0; });
}

constexpr int kAround = 24, kRings = 18;

int vertex(int i, int j) { return 1 + (j - 1) * kAround + (i + kAround) % kAround; }

/// Returns the edges of a jagged ring around the egg. Each edge goes up or down by one ring of the mesh.
std::vector<VertexPair> jagged_ring(int j) {
  std::vector<VertexPair> edges;
  for (int i = 0; i < kAround; ++i) edges.push_back({vertex(i, j + i % 2), vertex(i + 1, j + (i + 1) % 2)});
  return edges;
}

/// Returns the smooth version of a set of seams along these edges. strain: claimed strain of the set along the edges.
DartProposal smoothed(const FlattenInput& input, const std::vector<VertexPair>& edges, double strain = 1,
                      const CutOptions& cut_options = {}, double most_strain = 10, const Options& options = {}) {
  const Progress no_progress;
  CutProgress progress(no_progress);
  const SurfaceToCut surface(input, options);
  const ExactEvaluation exact(surface, options, progress.token());
  const FlatPieces pieces = exact.uncut();
  DartProposal set;
  set.edges = edges;
  set.num_pieces = figures_of(exact.with_cut(pieces, edges)).num_pieces;
  set.strain = strain;
  set.energy = strain;
  return smooth_set(set, most_strain, pieces, 0, cut_options, exact);
}

/// Returns the largest angle in radians by which a seam turns in space at a vertex.
double sharpest_bend(const FlattenInput& input) {
  std::map<int, std::vector<int>> beside;
  for (const auto& ends : input.seams.rowwise()) {
    beside[ends[0]].push_back(ends[1]);
    beside[ends[1]].push_back(ends[0]);
  }
  double sharpest = 0;
  for (const auto& [v, others] : beside) {
    if (others.size() != 2) continue;
    const Eigen::RowVector3d before = input.vertices.row(v) - input.vertices.row(others[0]);
    const Eigen::RowVector3d after = input.vertices.row(others[1]) - input.vertices.row(v);
    sharpest = std::max(sharpest, std::atan2(before.cross(after).norm(), before.dot(after)));
  }
  return sharpest;
}

TEST(SmoothSets, ReplaceAJaggedRingByASmoothOne) {
  const FlattenInput input = egg(kAround, kRings);
  const std::vector<VertexPair> ring = jagged_ring(8);
  const DartProposal set = smoothed(input, ring);
  ASSERT_EQ(set.paths.size(), 1U);
  EXPECT_TRUE(set.edges.empty());
  EXPECT_EQ(set.num_pieces, 2);
  const FlattenInput cut = test::with_paths(input, set.paths);
  EXPECT_GT(sharpest_bend(test::with_seams(input, ring)), 60 * kPi / 180);
  EXPECT_LT(sharpest_bend(cut), 45 * kPi / 180);  // 30 degrees on the surface, plus the curvature of the egg
  EXPECT_NEAR(set.length, test::length_of_seams(cut), 1e-9);
}

TEST(SmoothSets, ClaimTheEnergyOfTheFabric) {
  const FlattenInput input = egg(kAround, kRings);
  Options options;
  options.cloth = cloth_preset("woven").cloth;
  const DartProposal set = smoothed(input, jagged_ring(8), 5, {}, 10, options);
  ASSERT_FALSE(set.paths.empty());
  const double energy = test::energy_of(flatten(test::with_paths(input, set.paths), options), true);
  EXPECT_NEAR(set.energy, energy, 1e-6 * energy);
}

TEST(SmoothSets, ClaimTheLengthInTheMiddleOfTheMaterial) {
  const FlattenInput input = egg(kAround, kRings);
  Options options;
  options.thickness = 0.2;
  const DartProposal set = smoothed(input, jagged_ring(8), 1, {}, 10, options);
  ASSERT_FALSE(set.paths.empty());
  const FlattenInput cut = test::with_paths(input, set.paths);
  EXPECT_NEAR(set.length, test::length_of_seams(move_to_middle(cut, options)), 1e-9);
  EXPECT_GT(set.length, 1.05 * test::length_of_seams(cut));
}

TEST(SmoothSets, DoNotDependOnHowTheModelIsGiven) {
  const FlattenInput input = egg(kAround, kRings);
  ASSERT_NE(input.vertices.rows() % 7, 0);
  const std::vector<VertexPair> ring = jagged_ring(8);
  const DartProposal set = smoothed(input, ring);
  const DartProposal other = smoothed(test::disguised(input), test::disguised(input, ring));
  ASSERT_FALSE(set.paths.empty());
  EXPECT_NEAR(other.strain, set.strain, 1e-6);
  EXPECT_NEAR(other.length, set.length, 1e-6 * set.length);
}

TEST(SmoothSets, KeepEdgesIfTheStrainIsTooHigh) {
  const std::vector<VertexPair> ring = jagged_ring(8);
  const DartProposal set = smoothed(egg(kAround, kRings), ring, 0.01);
  EXPECT_EQ(set.edges, ring);
  EXPECT_TRUE(set.paths.empty());
}

/// Returns the jagged ring, and two jagged lines from the ring to the upper pole, which are mirror images across y = 0.
std::vector<VertexPair> symmetric_set() {
  std::vector<VertexPair> edges = jagged_ring(8);
  for (const int side : {1, -1}) {
    std::vector<int> line;
    for (int j = 8; j < kRings; ++j) line.push_back(vertex(side * (6 + (j > 10 ? j % 2 : 0)), j));
    line.push_back(1 + kAround * (kRings - 1));
    for (std::size_t i = 1; i < line.size(); ++i) edges.push_back({line[i - 1], line[i]});
  }
  return edges;
}

TEST(SmoothSets, StaySymmetricWithinTheStrainAllowed) {
  const FlattenInput input = egg(kAround, kRings);
  const std::vector<VertexPair> edges = symmetric_set();
  const double free = smoothed(input, edges).strain;
  const FlattenInput along_edges = test::with_seams(input, edges);
  const double least = test::most_strain(along_edges, flatten(along_edges));
  ASSERT_GT(free, 1.01 * least);  // otherwise the limit changes nothing
  for (const double share : {0.9, 1.0}) {
    const double most_strain = least + share * (free - least);
    const DartProposal set = smoothed(input, edges, 1, {}, most_strain);
    ASSERT_FALSE(set.paths.empty()) << share;
    EXPECT_LE(set.strain, most_strain);
    const FlattenInput cut = test::with_paths(input, set.paths);
    EXPECT_EQ(static_cast<int>(flatten(cut).pieces.size()), 3);
    for (const Eigen::RowVector3d& place : cut.vertices.rowwise()) {
      const Eigen::RowVector3d image = place.cwiseProduct(Eigen::RowVector3d(1, -1, 1));
      EXPECT_LT((cut.vertices.rowwise() - image).rowwise().norm().minCoeff(), 1e-6);
    }
  }
}

double narrowest_piece(const FlattenInput& input) {
  const Options options;
  const SurfaceToCut surface(input, options);
  const FlatPieces pieces = ExactEvaluation(surface, options, StopToken()).uncut();
  double width = 1;
  for (const auto& piece : pieces) width = std::min(width, flat_width(piece->chart.mesh, piece->uv, 1));
  return width;
}

/// Returns the edges of a ring around the egg with a tongue above it.
std::vector<VertexPair> ring_with_tongue() {
  std::vector<VertexPair> edges;
  for (int i = 0; i < kAround; ++i) edges.push_back({vertex(i, 8), vertex(i + 1, 8)});
  for (int j = 8; j < 11; ++j) edges.push_back({vertex(0, j), vertex(0, j + 1)});
  for (int i = 0; i < 4; ++i) edges.push_back({vertex(i, 11), vertex(i + 1, 11)});
  for (int j = 11; j > 8; --j) edges.push_back({vertex(4, j), vertex(4, j - 1)});
  return edges;
}

TEST(SmoothSets, KeepTheWidthOfPieces) {
  const FlattenInput input = egg(kAround, kRings);
  const std::vector<VertexPair> edges = ring_with_tongue();
  const double before = narrowest_piece(test::with_seams(input, edges));
  const DartProposal any_width = smoothed(input, edges);
  ASSERT_FALSE(any_width.paths.empty());
  const double after = narrowest_piece(test::with_paths(input, any_width.paths));
  ASSERT_LT(after, 0.9 * before);
  CutOptions cut_options;
  cut_options.narrowest = (after + before) / 2;
  const DartProposal wide = smoothed(input, edges, 1, cut_options);
  const FlattenInput cut = wide.paths.empty() ? test::with_seams(input, edges) : test::with_paths(input, wide.paths);
  EXPECT_GE(narrowest_piece(cut), cut_options.narrowest);
}

/// Merges the pieces of a set of seams along edges.
struct MergedSet {
  MergedSet(FlattenInput given, const std::vector<VertexPair>& edges, const MergeRules& rules)
      : input(std::move(given)), merger(piece, rules, cut_options, exact) {
    cut_options.narrowest = rules.narrowest;
    const PieceFigures figures = figures_of(exact.with_cut(pieces, edges));
    DartProposal set;
    set.paths = paths_along(input.faces, edges);
    set.strain = figures.strain;
    set.num_pieces = figures.num_pieces;
    merger.go_on(set);
  }

  const FlattenInput input;  // the members below refer to it
  const InternalOptions options;
  CutOptions cut_options;
  const SurfaceToCut surface{input, options};
  const ExactEvaluation exact{surface, options, StopToken()};
  const FlatPieces pieces = exact.uncut();
  const Chart chart = in_canonical_order(pieces[0]->chart, StopToken());
  const std::vector<VertexHandle> no_image;
  const PieceToCut piece{pieces, 0, chart, no_image};
  SmoothMerger merger;
};

TEST(SmoothMerger, KeepsTheWidthOfPiecesWhileItSmooths) {
  const FlattenInput input = egg(kAround, kRings);
  const std::vector<VertexPair> edges = ring_with_tongue();
  const auto width = [&](double narrowest) {
    MergedSet set(input, edges, {narrowest, 0, 0});
    set.merger.merge(1, 10, [](double) {});
    return narrowest_piece(test::with_paths(input, set.merger.smooth(10).paths));
  };
  const double before = narrowest_piece(test::with_seams(input, edges)), after = width(0);
  ASSERT_LT(after, 0.9 * before);
  const double narrowest = (after + before) / 2;
  EXPECT_GE(width(narrowest), narrowest);
}

/// A strip of four pieces. A bump makes the last two pieces hard to join.
TEST(SmoothMerger, UndoesTheLastMergesAfterTheLastAttempt) {
  const int n = 16, rows = 4;
  const FlattenInput strip = test::make_grid(n, rows, [](double s, double t) {
    const double x = 4 * s, y = (2 - 1.6 * s) * (t - 0.5);
    return Eigen::Vector3d(x, y, 0.5 * std::exp(-4 * ((x - 3) * (x - 3) + y * y)));
  });
  std::vector<std::vector<VertexPair>> seams;  // the longest, which is opened first, is the last
  for (const int column : {12, 8, 4}) {
    const std::vector<int> line = test::grid_column(n, rows, column);
    seams.emplace_back();
    for (std::size_t i = 1; i < line.size(); ++i) seams.back().push_back({line[i - 1], line[i]});
  }
  const auto first = [&](std::size_t count) {
    std::vector<VertexPair> edges;
    for (std::size_t i = 0; i < count; ++i) edges.insert(edges.end(), seams[i].begin(), seams[i].end());
    return edges;
  };
  const auto strain = [&](std::size_t count) {
    const FlattenInput cut = test::with_seams(strip, first(count));
    return test::most_strain(cut, flatten(cut));
  };
  for (const std::size_t count : {1U, 2U}) {
    const double most_strain = (strain(count) + strain(count - 1)) / 2;
    ASSERT_LT(strain(count), strain(count - 1));
    MergedSet set(strip, first(3), {0, 0, 1});
    EXPECT_TRUE(set.merger.merge(2 * strain(0) / most_strain, most_strain, [](double) {}));
    EXPECT_EQ(test::undirected(cut_mesh(strip.vertices, strip.faces, set.merger.set().paths).edges),
              test::undirected(first(count)));
    EXPECT_LE(set.merger.set().strain, most_strain);
  }
}

TEST(SmoothSets, DoNotCrossWires) {
  FlattenInput input = egg(kAround, kRings);
  std::vector<int> wire;
  for (int j = 7; j < 10; ++j) wire.push_back(vertex(0, j));
  test::add_wire(input, wire);
  const DartProposal set = smoothed(input, jagged_ring(8), 5);
  ASSERT_FALSE(set.paths.empty());
  const CutMesh cut = cut_mesh(input.vertices, input.faces, set.paths);
  for (const std::vector<int>& divided : cut.sources.divided_edges) {
    for (std::size_t i = 1; i < wire.size(); ++i)
      EXPECT_NE(std::set<int>({divided.front(), divided.back()}), std::set<int>({wire[i - 1], wire[i]}));
  }
}

TEST(SmoothSets, DoNotTouchTheTipOfADart) {
  const FlattenInput input = egg(kAround, kRings);
  std::vector<VertexPair> edges;
  for (int i = 4; i < kAround; ++i) edges.push_back({vertex(i, 8 + i % 2), vertex(i + 1, 8 + (i + 1) % 2)});
  for (int j = 8; j < 12; ++j) edges.push_back({vertex(0, j), vertex(0, j + 1)});
  for (int i = 0; i < 4; ++i) edges.push_back({vertex(i, 12), vertex(i + 1, 12)});
  for (int j = 12; j > 8; --j) edges.push_back({vertex(4, j), vertex(4, j - 1)});
  for (int j = 8; j < 11; ++j) edges.push_back({vertex(2, j), vertex(2, j + 1)});  // a line under the arch
  const DartProposal set = smoothed(input, edges);
  ASSERT_FALSE(set.paths.empty());
  const std::vector<VertexPair> cut = cut_mesh(input.vertices, input.faces, set.paths).edges;
  std::map<int, int> count;
  for (const VertexPair& edge : cut) {
    for (const int v : edge) ++count[v];
  }
  EXPECT_EQ(std::count_if(count.begin(), count.end(), [](const auto& each) { return each.second > 2; }), 0);
  EXPECT_EQ(std::count_if(count.begin(), count.end(), [](const auto& each) { return each.second == 1; }), 2);
}

TEST(SmoothSets, KeepTheCreasesOfABox) {
  const std::vector<std::array<double, 3>> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::array<int, 3>> faces{{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                              {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  const FlattenInput box = test::mesh_of(corners, faces);
  const std::vector<VertexPair> lid{{4, 5}, {5, 6}, {6, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  EXPECT_EQ(smoothed(box, lid, 0).edges, lid);
}

/// Returns an egg with a free wire along one edge. Because of the wire, the search does not divide the egg into parts.
FlattenInput egg_with_wire(int around, int rings) {
  FlattenInput input = egg(around, rings);
  test::add_wire(input, {input.faces(0, 0), input.faces(0, 1)}, std::numeric_limits<double>::infinity());
  return input;
}

CutOptions smooth_up_to(double strain) {
  CutOptions cut_options;
  cut_options.strain = strain;
  cut_options.is_smooth = true;
  return cut_options;
}

TEST(ProposeSeams, MergesPiecesWhoseOutlinesAreSmooth) {
  const FlattenInput input = egg_with_wire(16, 12);
  const CutOptions cut_options = smooth_up_to(0.05);
  const DartProposal finest = propose_seams(input, {}, cut_options).front();
  EXPECT_TRUE(finest.edges.empty());
  EXPECT_LE(finest.strain, 0.05);
  EXPECT_LT(sharpest_bend(test::with_paths(input, finest.paths)), 45 * kPi / 180);
}

TEST(ProposeSeams, ReturnsSmoothSetsAndCanBeCanceledWhileItSmooths) {
  const FlattenInput input = egg_with_wire(8, 6);
  const CutOptions cut_options = smooth_up_to(0.2);
  int num_smooth = 0;
  std::vector<double> reached;
  const auto report = [&](const std::string&, double share) {
    reached.push_back(share);
    return true;
  };
  for (const DartProposal& set : propose_seams(input, {}, cut_options, report)) {
    num_smooth += set.edges.empty() ? 1 : 0;
    EXPECT_FALSE(set.paths.empty());
    test::expect_figures(input, set);
  }
  EXPECT_GT(num_smooth, 0);
  EXPECT_TRUE(std::is_sorted(reached.begin(), reached.end()));
  const auto in_smoothing = std::upper_bound(reached.begin(), reached.end(), 0.35);
  EXPECT_GT(std::set<double>(in_smoothing, reached.end()).size(), 10U);
  double last = 0;
  const auto stop = [&](const std::string&, double share) {
    last = share;
    return share < 0.4;
  };
  const std::vector<DartProposal> stopped = propose_seams(input, {}, cut_options, stop);
  EXPECT_LT(last, 0.5);
  ASSERT_FALSE(stopped.empty());
  EXPECT_FALSE(stopped.back().edges.empty());  // the last set was not smooth yet
}

}  // namespace
}  // namespace wirewarp::test_smooth_sets
