// SPDX-License-Identifier: GPL-3.0-or-later
// Seams that a set can do without: merged pieces keep the allowed strain and the least width.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cuts/propose/flat_width.h"
#include "cuts/propose/merge_sections.h"
#include "cuts/propose/solidity.h"
#include "test_meshes.h"
#include "wirewarp/cloth.h"

namespace wirewarp::test_merge_sections {
namespace {

CutState merge_sections(const CutState& state, const Chart& chart, const ExactEvaluation& exact, double most_strain,
                        double narrowest = 0, double least_solidity = 0) {
  const MirroredCuts mirrored(chart, {});
  SectionMerger merger(state, chart, mirrored, exact, narrowest, least_solidity);
  merger.run(most_strain, [](double) {});
  return merger.state();
}

TEST(MergeSections, KeepsOneOfThreeSeamsOfATube) {
  const int around = 16, rows = 8;
  const double height = 4;
  const FlattenInput tube = test::cylinder_tube(around, rows, 1, height);
  std::vector<VertexPair> cut;
  for (const int line : {0, 5, 9}) {
    const std::vector<int> vertices = test::tube_line(around, rows, line);
    for (std::size_t i = 1; i < vertices.size(); ++i) cut.push_back({vertices[i - 1], vertices[i]});
  }
  const SurfaceToCut surface(tube, Options());
  const ExactEvaluation exact(surface, Options(), StopToken());
  const FlatPieces uncut = exact.uncut();
  const Chart& chart = uncut[0]->chart;
  const CutState state{PartMap(chart).mask_of(cut), exact.with_cut(uncut, cut)};
  ASSERT_EQ(state.pieces.size(), 3U);
  const CutState merged = merge_sections(state, chart, exact, 1e-6);
  ASSERT_EQ(merged.pieces.size(), 1U);
  EXPECT_FALSE(merged.pieces[0]->error);
  EXPECT_NEAR(length_of_cut(chart.mesh, merged.cut), height, 1e-12);
}

FlattenInput bump(int n) {
  return test::make_grid(n, n, [](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;
    return Eigen::Vector3d(x, y, 0.5 * std::exp(-3 * (x * x + y * y)));
  });
}

std::vector<VertexPair> across(int n) {
  std::vector<VertexPair> cut;
  const std::vector<int> column = test::grid_column(n, n, n / 2);
  for (std::size_t i = 1; i < column.size(); ++i) cut.push_back({column[i - 1], column[i]});
  return cut;
}

TEST(MergeSections, MeasuresTheThreadsOfAFabric) {
  const FlattenInput input = bump(8);
  Options options;
  // A woven fabric shears, so its threads stretch only a quarter as much as other materials.
  options.cloth = cloth_preset("woven").cloth;
  const SurfaceToCut surface(input, options);
  const ExactEvaluation exact(surface, options, StopToken());
  const FlatPieces uncut = exact.uncut();
  const Chart& chart = uncut[0]->chart;
  const CutState state{PartMap(chart).mask_of(across(8)), exact.with_cut(uncut, across(8))};
  const double most = 1.001 * uncut[0]->strain;
  EXPECT_TRUE(is_empty(merge_sections(state, chart, exact, most).cut));
}

TEST(MergeSections, KeepsTheSeamsThatLimitTheStrain) {
  const FlattenInput input = bump(8);
  const std::vector<VertexPair> cut = across(8);
  const SurfaceToCut surface(input, Options());
  const ExactEvaluation exact(surface, Options(), StopToken());
  const FlatPieces uncut = exact.uncut();
  const Chart& chart = uncut[0]->chart;
  const CutState state{PartMap(chart).mask_of(cut), exact.with_cut(uncut, cut)};
  const double cut_strain = std::max(state.pieces[0]->strain, state.pieces[1]->strain);
  ASSERT_LT(cut_strain, uncut[0]->strain);
  for (const double most : {(cut_strain + uncut[0]->strain) / 2, uncut[0]->strain}) {
    const CutState merged = merge_sections(state, chart, exact, most);
    for (const std::shared_ptr<const FlatPiece>& piece : merged.pieces) EXPECT_LE(piece->strain, most);
    EXPECT_EQ(is_empty(merged.cut), most == uncut[0]->strain);
  }
}

/// Two squares of side 4, and between them a bar that is 3 long and 1 wide.
FlattenInput dumbbell() {
  return test::keep_faces(test::flat_rectangle(22, 8, 11, 4),
                          [](const Eigen::Vector3d& p) { return p.x() < 4 || p.x() > 7 || std::abs(p.y() - 2) < 0.5; });
}

/// Returns the edges across a bar of width 1 at this place. middle: its center line.
std::vector<VertexPair> across_bar(const FlattenInput& input, double x, double middle = 2) {
  const auto at = [&](double y) { return test::nearest_vertex(input, {x, y, 0}); };
  return {{at(middle - 0.5), at(middle)}, {at(middle), at(middle + 0.5)}};
}

TEST(FlatWidth, IsTheDiameterOfTheLargestDiskThatMovesThrough) {
  const auto width = [](const FlattenInput& input, double most) {
    const SurfaceToCut surface(input, Options());
    const std::shared_ptr<const FlatPiece> piece = ExactEvaluation(surface, Options(), StopToken()).uncut()[0];
    const double found = flat_width(piece->chart.mesh, piece->uv, most);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix() * Eigen::Vector2d(1, -1).asDiagonal();
    EXPECT_NEAR(flat_width(piece->chart.mesh, piece->uv * turn, most), found, 1e-9 * most);
    return found;
  };
  EXPECT_NEAR(width(test::flat_rectangle(6, 2, 3, 1), 1.5), 1, 0.07 * 1.5);
  EXPECT_EQ(width(test::flat_rectangle(6, 2, 3, 1), 0.5), 0.5);
  EXPECT_NEAR(width(test::flat_annulus(64, 3, 1, 2), 1.5), 1, 0.07 * 1.5);
  EXPECT_NEAR(width(dumbbell(), 1.5), 1, 0.07 * 1.5);
  const FlattenInput with_tail = test::keep_faces(test::flat_rectangle(12, 8, 6, 4), [](const Eigen::Vector3d& p) {
    return p.x() < 4 || std::abs(p.y() - 1.75) < 0.25;  // a tail of area 1, which is less than a tenth
  });
  EXPECT_NEAR(width(with_tail, 5), 4, 0.07 * 5);
}

TEST(MergeSections, MakesNoNarrowPieceOfWideOnes) {
  const FlattenInput input = dumbbell();
  const SurfaceToCut surface(input, Options());
  const ExactEvaluation exact(surface, Options(), StopToken());
  const FlatPieces uncut = exact.uncut();
  const Chart& chart = uncut[0]->chart;
  const auto num_merged = [&](std::vector<VertexPair> cut, double narrowest) {
    const CutState state{PartMap(chart).mask_of(cut), exact.with_cut(uncut, cut)};
    return merge_sections(state, chart, exact, 1e-6, narrowest).pieces.size();
  };
  const std::vector<VertexPair> middle = across_bar(input, 5.5);
  EXPECT_EQ(num_merged(middle, 0), 1U);
  EXPECT_EQ(num_merged(middle, 0.9), 1U);
  EXPECT_EQ(num_merged(middle, 1.02), 2U);  // the bar is too narrow, but by less than the error of widths
  EXPECT_EQ(num_merged(middle, 2), 2U);
  std::vector<VertexPair> both_ends = across_bar(input, 4);
  for (const VertexPair& edge : across_bar(input, 7)) both_ends.push_back(edge);
  EXPECT_EQ(num_merged(both_ends, 2), 2U);  // the bar is too narrow, so it is joined to one square
}

TEST(Solidity, IsTheShareOfTheConvexHull) {
  const auto share = [](const FlattenInput& input) {
    const SurfaceToCut surface(input, Options());
    return solidity(*ExactEvaluation(surface, Options(), StopToken()).uncut()[0]);
  };
  EXPECT_NEAR(share(test::flat_rectangle(6, 2, 3, 1)), 1, 1e-9);
  EXPECT_NEAR(share(test::flat_annulus(64, 3, 1, 2)), 3.0 / 4, 1e-9);  // both circles are polygons of one shape
  EXPECT_NEAR(share(dumbbell()), 35.0 / 44, 1e-9);
}

TEST(MergeSections, MakesNoPieceWithLongArms) {
  const FlattenInput input = dumbbell();
  const SurfaceToCut surface(input, Options());
  const ExactEvaluation exact(surface, Options(), StopToken());
  const FlatPieces uncut = exact.uncut();
  const Chart& chart = uncut[0]->chart;
  const std::vector<VertexPair> middle = across_bar(input, 5.5);
  const CutState halves{PartMap(chart).mask_of(middle), exact.with_cut(uncut, middle)};
  const auto num_merged = [&](double least_solidity) {
    return merge_sections(halves, chart, exact, 1e-6, 0, least_solidity).pieces.size();
  };
  const double whole = solidity(*uncut[0]);
  for (const std::shared_ptr<const FlatPiece>& half : halves.pieces) EXPECT_GT(solidity(*half), whole + 0.05);
  EXPECT_EQ(num_merged(whole - 1e-6), 1U);
  EXPECT_EQ(num_merged(whole + 1e-6), 2U);
}

TEST(MergeSections, JoinsPiecesThatAreEquallyNarrow) {
  for (const int n : {12, 20}) {
    const FlattenInput bar = test::flat_rectangle(n, 2, n / 2.0, 1);
    const SurfaceToCut surface(bar, Options());
    const ExactEvaluation exact(surface, Options(), StopToken());
    const FlatPieces uncut = exact.uncut();
    const Chart& chart = uncut[0]->chart;
    for (int k = 2; k <= n - 2; ++k) {
      const std::vector<VertexPair> cut = across_bar(bar, k / 2.0, 0.5);
      const CutState state{PartMap(chart).mask_of(cut), exact.with_cut(uncut, cut)};
      ASSERT_EQ(state.pieces.size(), 2U);
      EXPECT_EQ(merge_sections(state, chart, exact, 1e-6, 2).pieces.size(), 1U) << n << " " << k;
    }
  }
}

TEST(MergeSections, JoinsTheHalvesOfARing) {
  // Half a ring covers the same share of its convex hull as the whole ring, up to rounding.
  const int around = 32;
  for (const double angle : {0.0, 0.3, 0.7}) {
    FlattenInput ring = test::flat_annulus(around, 2, 0.9, 1);
    const auto cut_at = [&](double x) {
      const auto at = [&](double radius) { return test::nearest_vertex(ring, {radius * x, 0, 0}); };
      return std::vector<VertexPair>{{at(0.9), at(0.95)}, {at(0.95), at(1)}};
    };
    const std::vector<VertexPair> left = cut_at(-1);
    std::vector<VertexPair> both = cut_at(1);
    both.insert(both.end(), left.begin(), left.end());
    ring.vertices *= Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix().transpose();
    const SurfaceToCut surface(ring, Options());
    const ExactEvaluation exact(surface, Options(), StopToken());
    const FlatPieces uncut = exact.uncut();
    const Chart& chart = uncut[0]->chart;
    const CutState state{PartMap(chart).mask_of(both), exact.with_cut(uncut, both)};
    ASSERT_EQ(state.pieces.size(), 2U);
    // The limit is generous, because free maps of rings overestimate the strain.
    EXPECT_EQ(merge_sections(state, chart, exact, 0.1, 0, 0.6).pieces.size(), 1U) << angle;
  }
}

}  // namespace
}  // namespace wirewarp::test_merge_sections
