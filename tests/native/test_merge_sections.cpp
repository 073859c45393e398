// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the search for seams that a suggested set does not need.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "base/in_threads.h"
#include "base/planar.h"
#include "cuts/propose/cut_faces.h"
#include "cuts/propose/flat_width.h"
#include "cuts/propose/merge_sections.h"
#include "surface/charts/surface_cut.h"
#include "surface/mesh/edge_table.h"
#include "test_meshes.h"
#include "wirewarp/cloth.h"

namespace wirewarp::test_merge_sections {
namespace {

CutState merge_sections(const CutState& state, const Chart& chart, const ExactEvaluation& exact, double most_strain,
                        double narrowest = 0, double least_solidity = 0) {
  const MirroredCuts mirrored(chart, {});
  SectionMerger merger(state, chart, mirrored, exact, {narrowest, least_solidity});
  merger.run(most_strain, [](double) {});
  return merger.state();
}

struct CutSurface {
  explicit CutSurface(FlattenInput given, const Options& chosen = {}) : input(std::move(given)), options(chosen) {}

  CutState with(const std::vector<VertexPair>& cut) const {
    return {PartMap(chart).mask_of(cut), exact.with_cut(uncut, cut)};
  }

  const FlattenInput input;  // the members below refer to it
  const InternalOptions options;
  const SurfaceToCut surface{input, options};
  const ExactEvaluation exact{surface, options, StopToken()};
  const FlatPieces uncut = exact.uncut();
  const Chart& chart = uncut[0]->chart;
};

std::vector<VertexPair> edges_of(const std::vector<int>& line) {
  std::vector<VertexPair> edges;
  for (std::size_t i = 1; i < line.size(); ++i) edges.push_back({line[i - 1], line[i]});
  return edges;
}

std::vector<VertexPair> across(int n) { return edges_of(test::grid_column(n, n, n / 2)); }

std::vector<VertexPair> both(std::vector<VertexPair> some, const std::vector<VertexPair>& others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

/// Several rows and columns of a grid are cut, so that sections are tried at the same time.
TEST(MergeSections, TheNumberOfCoresChangesNoResult) {
  const int n = 12;
  std::vector<VertexPair> cut;
  for (const int at : {3, 6, 9}) {
    for (const std::vector<int>& line : {test::grid_column(n, n, at), test::grid_row(n, at)}) {
      cut = both(cut, edges_of(line));
    }
  }
  const CutSurface surface(test::bump(n));
  const CutState state = surface.with(cut);
  const auto merged_for = [&](double strain) { return merge_sections(state, surface.chart, surface.exact, strain); };
  for (const double strain : {0.02, 0.1}) {
    const CutState on_all = merged_for(strain);
    const OnOneCore on_one_core;
    EXPECT_EQ(on_all.cut, merged_for(strain).cut) << strain;
  }
}

TEST(MergeSections, MeasuresTheThreadsOfAFabric) {
  Options options;
  // Woven fabric shears, so its threads stretch only a quarter as much as an isotropic material.
  options.cloth = cloth_preset("woven").cloth;
  const CutSurface sheet(test::bump(8), options);
  const double most = 1.001 * sheet.uncut[0]->strain;
  EXPECT_TRUE(is_empty(merge_sections(sheet.with(across(8)), sheet.chart, sheet.exact, most).cut));
}

TEST(MergeSections, KeepsTheSeamsThatLimitTheStrain) {
  const CutSurface sheet(test::bump(8));
  const CutState state = sheet.with(across(8));
  const double cut_strain = std::max(state.pieces[0]->strain, state.pieces[1]->strain);
  const double whole_strain = sheet.uncut[0]->strain;
  ASSERT_LT(cut_strain, whole_strain);
  for (const double most : {(cut_strain + whole_strain) / 2, whole_strain}) {
    const CutState merged = merge_sections(state, sheet.chart, sheet.exact, most);
    for (const std::shared_ptr<const FlatPiece>& piece : merged.pieces) EXPECT_LE(piece->strain, most);
    EXPECT_EQ(is_empty(merged.cut), most == whole_strain);
  }
}

/// Returns two squares of side 4, connected by a bar that is 3 long and 1 wide.
FlattenInput dumbbell() {
  return test::keep_faces(test::flat_rectangle(22, 8, 11, 4),
                          [](const Eigen::Vector3d& p) { return p.x() < 4 || p.x() > 7 || std::abs(p.y() - 2) < 0.5; });
}

std::vector<VertexPair> across_bar(const FlattenInput& input, double x, double middle = 2) {
  const auto at = [&](double y) { return test::nearest_vertex(input, {x, y, 0}); };
  return {{at(middle - 0.5), at(middle)}, {at(middle), at(middle + 0.5)}};
}

TEST(FlatWidth, IsTheDiameterOfTheLargestDiskThatMovesThrough) {
  const auto width = [](const FlattenInput& input, double most) {
    const std::shared_ptr<const FlatPiece> piece = CutSurface(input).uncut[0];
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
    // The area of the tail is 1, less than a tenth of the piece, so the tail does not count.
    return p.x() < 4 || std::abs(p.y() - 1.75) < 0.25;
  });
  EXPECT_NEAR(width(with_tail, 5), 4, 0.07 * 5);
}

TEST(MergeSections, MakesNoNarrowPieceOfWideOnes) {
  const FlattenInput input = dumbbell();
  const CutSurface sheet(input);
  const auto num_merged = [&](const std::vector<VertexPair>& cut, double narrowest) {
    return merge_sections(sheet.with(cut), sheet.chart, sheet.exact, 1e-6, narrowest).pieces.size();
  };
  const std::vector<VertexPair> middle = across_bar(input, 5.5);
  EXPECT_EQ(num_merged(middle, 0), 1U);
  EXPECT_EQ(num_merged(middle, 0.9), 1U);
  EXPECT_EQ(num_merged(middle, 1.02), 2U);  // the bar is too narrow, but by less than the error of its width
  EXPECT_EQ(num_merged(middle, 2), 2U);
  // The bar is too narrow, so it is joined to one square.
  EXPECT_EQ(num_merged(both(across_bar(input, 4), across_bar(input, 7)), 2), 2U);
}

TEST(Solidity, IsTheShareOfTheConvexHull) {
  const auto share = [](const FlattenInput& input) { return solidity(*CutSurface(input).uncut[0]); };
  EXPECT_NEAR(share(test::flat_rectangle(6, 2, 3, 1)), 1, 1e-9);
  EXPECT_NEAR(share(test::flat_annulus(64, 3, 1, 2)), 3.0 / 4, 1e-9);  // exact, as both circles are similar polygons
  EXPECT_NEAR(share(dumbbell()), 35.0 / 44, 1e-9);
}

TEST(MergeSections, MakesNoPieceWithLongArms) {
  const CutSurface sheet(dumbbell());
  const CutState halves = sheet.with(across_bar(dumbbell(), 5.5));
  const auto num_merged = [&](double least_solidity) {
    return merge_sections(halves, sheet.chart, sheet.exact, 1e-6, 0, least_solidity).pieces.size();
  };
  const double whole = solidity(*sheet.uncut[0]);
  for (const std::shared_ptr<const FlatPiece>& half : halves.pieces) EXPECT_GT(solidity(*half), whole + 0.05);
  EXPECT_EQ(num_merged(whole - 1e-6), 1U);
  EXPECT_EQ(num_merged(whole + 1e-6), 2U);
}

/// A strip of two squares of side 2 and a square of side 1. separate() cuts it into these squares.
struct ThreeSquares : CutSurface {
  explicit ThreeSquares(const Options& chosen = {})
      : CutSurface(test::keep_faces(test::flat_rectangle(10, 4, 5, 2),
                                    [](const Eigen::Vector3d& p) { return p.x() < 4 || p.y() < 1; }),
                   chosen) {}

  std::vector<VertexPair> across(double x, double end) const {
    std::vector<VertexPair> edges;
    const auto at = [&](double y) { return test::nearest_vertex(input, {x, y, 0}); };
    for (double y = 0; y < end; y += 0.5) edges.push_back({at(y), at(y + 0.5)});
    return edges;
  }

  CutState separate() const { return with(both(across(2, 2), across(4, 1))); }

  bool is_open(const CutState& state, const std::vector<VertexPair>& edges) const {
    const CutMask mask = PartMap(chart).mask_of(edges);
    return std::equal(mask.begin(), mask.end(), state.cut.begin(), [](char a, char b) { return a == 0 || b == 0; });
  }
};

TEST(MergeSections, DoesNotMakeAPieceAgainThatWasUndone) {
  const ThreeSquares strip;
  const MirroredCuts mirrored(strip.chart, {});
  SectionMerger merger(strip.separate(), strip.chart, mirrored, strip.exact);
  const auto run = [&] { merger.run(1e-6, [](double) {}); };
  EXPECT_FALSE(merger.undo(merger.state().pieces)) << "there is nothing before the first state";
  run();
  ASSERT_TRUE(is_empty(merger.state().cut));
  EXPECT_TRUE(merger.undo(merger.state().pieces));
  for (int i = 0; i < 2; ++i) {
    run();
    EXPECT_FALSE(is_empty(merger.state().cut));
    EXPECT_TRUE(strip.is_open(merger.state(), strip.across(2, 2))) << "the longer section is opened first";
    merger.restart(0);
    EXPECT_EQ(merger.state().pieces.size(), 3U);
  }
}

TEST(MergeSections, MakesAPieceAgainIfACutRemainsInside) {
  const ThreeSquares strip;
  const MirroredCuts mirrored(strip.chart, {});
  SectionMerger merger(strip.with(strip.across(2, 2)), strip.chart, mirrored, strip.exact);
  const auto run = [&] { merger.run(1e-4, [](double) {}); };
  run();
  ASSERT_TRUE(is_empty(merger.state().cut));
  ASSERT_TRUE(merger.undo(merger.state().pieces));
  ASSERT_EQ(merger.state().pieces.size(), 2U);
  run();
  EXPECT_EQ(merger.state().pieces.size(), 1U);
  EXPECT_FALSE(is_empty(merger.state().cut));
}

TEST(MergeSections, KnowsTheFirstPiecesOfAStretchedFabricAgain) {
  // Each merged piece changes the shapes of its neighbors, because all sides of a seam have one length.
  Options options;
  options.cloth = cloth_preset("jersey").cloth;
  options.cloth->stretch = {0.1, 0};
  const ThreeSquares strip(options);
  const MirroredCuts mirrored(strip.chart, {});
  SectionMerger merger(strip.separate(), strip.chart, mirrored, strip.exact);
  const auto run = [&] { merger.run(1, [](double) {}); };
  run();
  ASSERT_TRUE(merger.undo(merger.state().pieces));
  ASSERT_EQ(merger.state().pieces.size(), 2U);
  ASSERT_TRUE(merger.undo(merger.state().pieces));  // one piece is the small square, in another shape than at first
  ASSERT_EQ(merger.state().pieces.size(), 3U);
  run();
  EXPECT_TRUE(strip.is_open(merger.state(), strip.across(4, 1)));
  EXPECT_FALSE(strip.is_open(merger.state(), strip.across(2, 2)));
}

TEST(MergeSections, OpensSectionsBesideSmallPiecesFirst) {
  const ThreeSquares strip;
  const MirroredCuts mirrored(strip.chart, {});
  SectionMerger merger(strip.separate(), strip.chart, mirrored, strip.exact);
  merger.run(1e-6, [](double) {});
  merger.undo(merger.state().pieces);  // the three squares are not joined again, but two of them may be
  for (const auto& [first, is_small_joined] : {std::pair(0.0, false), std::pair(1.5, true), std::pair(0.0, false)}) {
    merger.restart(first);
    merger.run(1e-6, [](double) {});
    EXPECT_EQ(strip.is_open(merger.state(), strip.across(2, 2)), !is_small_joined);
    EXPECT_EQ(strip.is_open(merger.state(), strip.across(4, 1)), is_small_joined);
  }
}

void expect_failures_on_other_meshes(const CutSurface& sheet, const FlatPieces& pieces) {
  ASSERT_EQ(pieces.size(), 2U);
  std::vector<int> faces(sheet.input.faces.rows());
  std::iota(faces.begin(), faces.end(), 0);
  const double most = most_strain(pieces);
  const auto failed = [&](const FlatPieces& there, double strain) {
    return failed_on_mesh({pieces, faces}, {there, faces}, strain);
  };
  EXPECT_TRUE(failed(pieces, most).empty());
  EXPECT_TRUE(failed({pieces[1], pieces[0]}, most).empty());
  EXPECT_EQ(failed(pieces, -1), pieces);
  EXPECT_EQ(failed({pieces[1]}, most), FlatPieces{pieces[0]});
  EXPECT_EQ(failed({pieces[0], pieces[1], pieces[1]}, most), FlatPieces{pieces[1]});
}

/// A piece touches itself at the common corner of two squares. The squares connect the corners of the piece there.
TEST(FlatPieces, MayTouchThemselvesAtCornersOfOtherPieces) {
  const int n = 6;
  const auto at = [](int i, int j) { return i + (n + 1) * j; };
  const std::vector<VertexPair> opened = edges_of({at(0, 3), at(1, 3), at(2, 3)});
  std::vector<VertexPair> cut = both(opened, edges_of({at(4, 3), at(5, 3), at(6, 3)}));
  cut = both(cut, edges_of({at(2, 3), at(3, 3), at(3, 4), at(2, 4), at(2, 3)}));
  cut = both(cut, edges_of({at(3, 3), at(3, 2), at(4, 2), at(4, 3), at(3, 3)}));
  const CutSurface sheet(test::flat_rectangle(n, n, n, n));
  const FlatPieces before = sheet.with(cut).pieces;
  ASSERT_EQ(before.size(), 4U);
  const FlatPieces after = sheet.exact.with_changed(before, sheet.exact.changed_by(before, {}, opened));
  EXPECT_EQ(after.size(), 3U);
  for (const auto& piece : after) EXPECT_FALSE(piece->error) << piece->error->what();
}

/// Two squares with a common corner are missing, so no face connects the corners of the rest there.
TEST(CutFaces, ReportsAPartThatTouchesItself) {
  const int n = 6;
  FlattenInput sheet = test::flat_rectangle(n, n, n, n);
  std::vector<int> faces;
  for (int f = 0; f < sheet.faces.rows(); ++f) {
    const Eigen::RowVector3d i = sheet.faces.row(f).unaryExpr([](int v) { return v % (n + 1); }).cast<double>();
    const Eigen::RowVector3d j = sheet.faces.row(f).unaryExpr([](int v) { return v / (n + 1); }).cast<double>();
    const int column = static_cast<int>(i.minCoeff()), row = static_cast<int>(j.minCoeff());
    if ((column == 2 && row == 3) || (column == 3 && row == 2)) continue;
    sheet.faces.row(static_cast<Eigen::Index>(faces.size())) = sheet.faces.row(f).eval();
    faces.push_back(static_cast<int>(faces.size()));
  }
  sheet.faces.conservativeResize(static_cast<Eigen::Index>(faces.size()), 3);
  const EdgeTable edges(sheet.faces, static_cast<int>(sheet.vertices.rows()));
  const Charts parts = cut_faces(sheet, fans_of_uncut_surface(sheet.faces, edges), faces, {}, StopToken());
  ASSERT_EQ(parts.charts.size(), 1U);
  ASSERT_TRUE(parts.charts[0].error);
  EXPECT_EQ(parts.charts[0].error->code, ErrorCode::non_manifold_vertex);
}

TEST(FlatPieces, AreFoundAgainByTheirArea) {
  const CutSurface sheet(test::bump(8));
  expect_failures_on_other_meshes(sheet, sheet.with(across(8)).pieces);
  const CutSurface rings(test::flat_annulus(32, 2, 1, 2));  // cut into two rings with a common center
  std::vector<VertexPair> middle;
  for (const EdgeHandle e : rings.chart.mesh.edges()) {
    const VertexPair ends = source_edge(rings.chart, rings.chart.mesh.halfedge_handle(e, 0));
    const auto is_in_middle = [&](int v) { return std::abs(rings.input.vertices.row(v).norm() - 1.5) < 1e-9; };
    if (is_in_middle(ends[0]) && is_in_middle(ends[1])) middle.push_back(ends);
  }
  expect_failures_on_other_meshes(rings, rings.with(middle).pieces);
}

TEST(MergeSections, JoinsPiecesThatAreEquallyNarrow) {
  const int n = 12;
  const FlattenInput bar = test::flat_rectangle(n, 2, n / 2.0, 1);
  const CutSurface sheet(bar);
  for (int k = 2; k <= n - 2; ++k) {
    const CutState state = sheet.with(across_bar(bar, k / 2.0, 0.5));
    ASSERT_EQ(state.pieces.size(), 2U);
    EXPECT_EQ(merge_sections(state, sheet.chart, sheet.exact, 1e-6, 2).pieces.size(), 1U) << k;
  }
}

/// A spiral ramp of more than one turn first overlaps itself when it is flattened, so the quick trial of its halves
/// fails. Narrow halves are joined nevertheless.
TEST(MergeSections, JoinsNarrowPiecesThatFirstOverlap) {
  const int n = 36;
  FlattenInput ramp = test::flat_rectangle(n, 2, 1.2, 1);
  for (auto place : ramp.vertices.rowwise()) {
    const double turn = 2 * kPi * place.x(), radius = 1 + 0.2 * place.y();
    place = Eigen::RowVector3d(radius * std::cos(turn), radius * std::sin(turn), 0.3 * place.x());
  }
  const CutSurface sheet(ramp);
  const CutState state = sheet.with(edges_of(test::grid_column(n, 2, n / 2)));
  ASSERT_EQ(state.pieces.size(), 2U);
  EXPECT_EQ(merge_sections(state, sheet.chart, sheet.exact, 1).pieces.size(), 2U);
  EXPECT_EQ(merge_sections(state, sheet.chart, sheet.exact, 1, 2).pieces.size(), 1U);
}

TEST(MergeSections, JoinsTheHalvesOfARing) {
  // A half of this ring covers as large a share of its convex hull as the whole ring. Rounding must not keep the seams.
  const int around = 32;
  for (const double angle : {0.0, 0.7}) {
    FlattenInput ring = test::flat_annulus(around, 2, 0.9, 1);
    const auto cut_at = [&](double x) {
      const auto at = [&](double radius) { return test::nearest_vertex(ring, {radius * x, 0, 0}); };
      return std::vector<VertexPair>{{at(0.9), at(0.95)}, {at(0.95), at(1)}};
    };
    const std::vector<VertexPair> cut = both(cut_at(1), cut_at(-1));
    ring.vertices *= Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix().transpose();
    const CutSurface sheet(ring);
    const CutState state = sheet.with(cut);
    ASSERT_EQ(state.pieces.size(), 2U);
    // The limit of the strain is generous, because free maps of rings overestimate the strain.
    EXPECT_EQ(merge_sections(state, sheet.chart, sheet.exact, 0.1, 0, 0.6).pieces.size(), 1U) << angle;
  }
}

}  // namespace
}  // namespace wirewarp::test_merge_sections
