// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that seams are removed if a model does not need them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "base/in_threads.h"
#include "base/planar.h"
#include "closed_meshes.h"
#include "disguise.h"
#include "eased_sheets.h"
#include "error_of.h"
#include "judge_cuts.h"
#include "test_meshes.h"
#include "wirewarp/propose.h"

namespace wirewarp::test_simplify_seams {
namespace {

constexpr int kAround = 16, kRows = 4;
constexpr double kHeight = 4;

FlattenInput tube_with_seams(const std::vector<int>& lines) {
  FlattenInput tube = test::cylinder_tube(kAround, kRows, 1, kHeight);
  for (const int line : lines) test::add_seam(tube, test::tube_line(kAround, kRows, line));
  return tube;
}

/// Returns a cube of side 1 with n by n squares on each side, and seams along its twelve edges.
FlattenInput cube(int n) {
  FlattenInput input = test::cubes(n, n, n, [](int, int, int) { return true; });
  input.vertices /= n;
  const auto is_on_rim = [&](int v) {
    return (input.vertices.row(v).array() == 0 || input.vertices.row(v).array() == 1).count() >= 2;
  };
  std::vector<VertexPair> seams;
  for (const auto& face : input.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      const Eigen::RowVector3d along = input.vertices.row(b) - input.vertices.row(a);
      if (a < b && is_on_rim(a) && is_on_rim(b) && (along.array() != 0).count() == 1) seams.push_back({a, b});
    }
  }
  return test::with_seams(input, seams);
}

/// Returns a sphere of eight gores, each cut across into three pieces.
FlattenInput sphere() {
  const int gores = 8, n = 2, rings = 9;
  FlattenInput input = test::sphere_of_gores(gores, n, rings);
  std::vector<VertexPair> across;
  for (Eigen::Index f = 0; f < input.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = input.faces(f, k), b = input.faces(f, (k + 1) % 3);
      const double z = input.vertices(a, 2);
      const bool is_level = std::abs(z - input.vertices(b, 2)) < 1e-9;
      if (a < b && is_level && std::abs(std::abs(z) - std::cos(3 * kPi / rings)) < 1e-9) across.push_back({a, b});
    }
  }
  return test::with_seams(input, across);
}

FlattenInput with_only(FlattenInput input, const std::vector<VertexPair>& seams) {
  input.seams.resize(0, 2);
  return test::with_seams(std::move(input), seams);
}

/// Expects that the claimed figures are those of new runs, and that each edge of a seam is either kept or opened.
void expect_true_figures(const FlattenInput& input, const SeamProposal& fewer) {
  const std::set<VertexPair> given = test::undirected(input.seams), kept = test::undirected(fewer.edges),
                             opened = test::undirected(fewer.opened);
  EXPECT_EQ(fewer.edges.size(), kept.size());
  EXPECT_EQ(kept.size() + opened.size(), given.size());
  EXPECT_TRUE(std::includes(given.begin(), given.end(), kept.begin(), kept.end()));
  EXPECT_TRUE(std::includes(given.begin(), given.end(), opened.begin(), opened.end()));
  test::expect_figures(input, {fewer.energy_before, fewer.strain_before, fewer.length_before, fewer.num_pieces_before});
  test::expect_figures(with_only(input, fewer.edges), {fewer.energy, fewer.strain, fewer.length, fewer.num_pieces});
  std::size_t along_paths = 0;
  for (const SurfacePath& path : fewer.paths) along_paths += path.faces.size() - 1;
  EXPECT_EQ(along_paths, fewer.edges.size());
}

TEST(SimplifySeams, KeepsOneOfThreeSeamsOfATube) {
  const FlattenInput tube = tube_with_seams({0, 5, 9});
  const SeamProposal fewer = simplify_seams(tube, {}, 0);
  EXPECT_EQ(fewer.num_pieces_before, 3);
  EXPECT_EQ(fewer.num_pieces, 1);
  EXPECT_NEAR(fewer.length_before, 3 * kHeight, 1e-12);
  EXPECT_NEAR(fewer.length, kHeight, 1e-12);
  EXPECT_FALSE(fewer.was_stopped);
  expect_true_figures(tube, fewer);
}

TEST(SimplifySeams, UnfoldsABoxToANet) {
  // The net of a cube is one piece: five edges, which form a spanning tree, join the six sides.
  FlattenInput box = cube(2);
  ASSERT_EQ(box.seams.rows(), 12 * 2);
  box.vertices.col(0) += 0.3 * box.vertices.col(1) + 0.1 * box.vertices.col(2);  // so that the box is not symmetric
  box.vertices.col(1) += 0.2 * box.vertices.col(2);
  const SeamProposal fewer = simplify_seams(box, {}, 1e-4);
  EXPECT_EQ(fewer.num_pieces_before, 6);
  EXPECT_EQ(fewer.num_pieces, 1);
  EXPECT_LE(fewer.strain, 1e-4);
  expect_true_figures(box, fewer);
}

TEST(SimplifySeams, KeepsMirroredPairsOfACubesSeams) {
  // If the cube has k pieces, its six sides are joined along 6 - k of the twelve edges. So 6 + k edges of length 1
  // remain seams.
  const FlattenInput input = cube(2);
  const SeamProposal fewer = simplify_seams(input, {}, 0);
  EXPECT_LE(fewer.num_pieces, 2);
  EXPECT_NEAR(fewer.length, 6 + fewer.num_pieces, 1e-12);
  expect_true_figures(input, fewer);
}

TEST(SimplifySeams, MergesTheGoresOfABallUpToTheStrain) {
  const FlattenInput input = sphere();
  double length = std::numeric_limits<double>::infinity();
  for (const double strain : {0.05, 0.3, std::numeric_limits<double>::infinity()}) {
    const SeamProposal fewer = simplify_seams(input, {}, strain);
    EXPECT_EQ(fewer.num_pieces_before, 24);
    EXPECT_LT(fewer.length, length);
    EXPECT_LE(fewer.strain, strain);
    expect_true_figures(input, fewer);
    length = fewer.length;
  }
  EXPECT_LT(length, test::length_of_seams(input) / 2);
}

TEST(SimplifySeams, MeasuresEachPartOfTheModelAlone) {
  // A tube with three seams, beside a ball in two halves. The ball has much more strain.
  const FlattenInput input = test::beside(tube_with_seams({0, 5, 9}), test::sphere_of_gores(2, 6, 8), 5);
  const SeamProposal fewer = simplify_seams(input, {}, 0.01);
  EXPECT_GT(fewer.strain_before, 0.1);
  EXPECT_LE(fewer.strain, fewer.strain_before);
  const FlattenResult result = flatten(with_only(input, fewer.edges));
  const auto is_of_tube = [](const Piece& piece) { return piece.source_face.front() < 2 * kAround * kRows; };
  EXPECT_EQ(std::count_if(result.pieces.begin(), result.pieces.end(), is_of_tube), 1);
  expect_true_figures(input, fewer);
}

TEST(SimplifySeams, NeverMakesTheWorstPieceWorse) {
  const int n = 8;
  FlattenInput bump = test::bump(n);
  test::add_seam(bump, test::grid_column(n, n, n / 2));
  const SeamProposal fewer = simplify_seams(bump, {}, 0);
  EXPECT_EQ(fewer.num_pieces, 2);
  EXPECT_LE(fewer.strain, fewer.strain_before);
  EXPECT_EQ(simplify_seams(bump, {}, 1).num_pieces, 1);
}

TEST(SimplifySeams, KeepsASeamWithAnEaseOnOneSide) {
  FlattenInput tube = tube_with_seams({0, 5, 9});
  const Ease ease = test::ease_along(test::tube_line(kAround, kRows, 5), 0.02);
  tube.eases.push_back(ease);
  const SeamProposal fewer = simplify_seams(tube, {}, 0.05);
  EXPECT_EQ(test::undirected(fewer.edges), test::undirected(ease.half_edges));
}

TEST(SimplifySeams, KeepsASeamOfThreeSides) {
  FlattenInput book = test::book(3, 4);
  const SeamProposal fewer = simplify_seams(book, {}, 0.5);
  EXPECT_EQ(test::undirected(fewer.edges), test::undirected(book.seams));
  EXPECT_EQ(fewer.num_pieces, 3);
}

TEST(SimplifySeams, HasNoFiguresIfAPieceHasNoFlatShape) {
  const FlattenInput tube = tube_with_seams({});
  const SeamProposal fewer = simplify_seams(tube, {}, 0.5);
  EXPECT_TRUE(fewer.edges.empty());
  EXPECT_EQ(fewer.strain, std::numeric_limits<double>::infinity());
  EXPECT_EQ(fewer.energy_before, std::numeric_limits<double>::infinity());
}

TEST(SimplifySeams, RemovesSeamsBesideANeighborWithoutAFlatShape) {
  // These are four strips of stretched fabric side by side. The third strip cannot be flattened.
  const int n = 8;
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double x = s - 0.625, y = t - 0.5;
    return Eigen::Vector3d(s, t, s < 0.5 || s > 0.75 ? 0 : 0.3 * std::exp(-40 * (x * x + y * y)));
  });
  for (const int column : {2, 4, 6}) test::add_seam(input, test::grid_column(n, n, column));
  for (int j = 0; j <= n; ++j) test::add_wire(input, {4 + (n + 1) * j, 5 + (n + 1) * j, 6 + (n + 1) * j});
  for (int j = 0; j < n; ++j) {
    for (const int i : {4, 5}) test::add_wire(input, {i + (n + 1) * j, i + 1 + (n + 1) * (j + 1)});
  }
  test::add_wire(input, test::grid_column(n, n, 5));
  Options options;
  options.cloth.emplace();
  options.cloth->stretch = {0.1, 0.05};
  options.grain = 0;
  const FlattenResult before = flatten(input, options);
  ASSERT_EQ(before.pieces.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(before.pieces[k].error.has_value(), k == 2) << k;
  const std::set<VertexPair> opened = test::undirected(simplify_seams(input, options, 0.2).opened);
  const std::vector<int> column = test::grid_column(n, n, 2);
  std::set<VertexPair> expected;
  for (std::size_t i = 1; i < column.size(); ++i) expected.insert({column[i - 1], column[i]});
  EXPECT_EQ(opened, expected);
}

TEST(SimplifySeams, DoesNotDependOnPositionOrientationAndNumbering) {
  FlattenInput input = sphere();
  input.vertices.col(0) *= 1.1;
  input.vertices.col(1) *= 0.9;
  input.vertices.col(2) += 0.2 * input.vertices.col(0).cwiseAbs2();
  FlattenInput other = test::disguised(input);
  other.seams.resize(0, 2);
  const std::set<VertexPair> seams = test::undirected(input.seams);
  other = test::with_seams(other, test::disguised(input, {seams.begin(), seams.end()}));
  const SeamProposal here = simplify_seams(input, {}, 0.2), there = simplify_seams(other, {}, 0.2);
  EXPECT_FALSE(here.opened.empty());
  EXPECT_EQ(test::undirected(test::disguised(input, here.edges)), test::undirected(there.edges));
  EXPECT_NEAR(here.strain, there.strain, 1e-5 * here.strain);
}

TEST(SimplifySeams, ReportsProgressThatNeverFallsAndEndsNearOne) {
  const OnOneCore on_one_core;  // only this thread reports, so on more cores the last report depends on their speed
  std::vector<double> reported;
  simplify_seams(sphere(), {}, 0.15, [&](const std::string& stage, double fraction) {
    EXPECT_EQ(stage, "cuts");
    reported.push_back(fraction);
    return true;
  });
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_LE(reported.back(), 1);
  EXPECT_GT(reported.back(), 0.8);
}

TEST(SimplifySeams, ReturnsTheBestSoFarWhenStopped) {
  const FlattenInput input = sphere();
  for (const double last : {0.11, 0.5}) {
    const SeamProposal fewer =
        simplify_seams(input, {}, 0.15, [&](const std::string&, double fraction) { return fraction < last; });
    EXPECT_TRUE(fewer.was_stopped);
    EXPECT_LE(fewer.strain, std::max(0.15, fewer.strain_before));
    expect_true_figures(input, fewer);
  }
  const auto stopped = [&] { simplify_seams(input, {}, 0.15, [](const std::string&, double) { return false; }); };
  EXPECT_EQ(test::error_of(stopped).code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace wirewarp::test_simplify_seams
