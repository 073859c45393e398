// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of plans of several cuts. strain_left is the strain of a new run with the cuts so far, and plans keep their
// limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "disguise.h"
#include "error_of.h"
#include "judge_cuts.h"
#include "test_meshes.h"
#include "wirewarp/propose.h"

namespace wirewarp::test_plan_cuts {
namespace {

/// Returns a sheet with two hills at one edge.
FlattenInput hills(int n) { return test::two_hills(n, 1.1); }

/// Returns the strain of the most strained piece if the input is flattened with the first num_cuts of these cuts.
double most_strain(FlattenInput input, const std::vector<DartProposal>& cuts, std::size_t num_cuts) {
  for (std::size_t i = 0; i < num_cuts; ++i) input = test::with_seams(std::move(input), cuts[i].edges);
  const FlattenResult result = flatten(input);
  for (const Piece& piece : result.pieces) EXPECT_FALSE(piece.error);
  return test::most_strain(input, result);
}

TEST(PlanCuts, StrainLeftIsThatOfAFreshRun) {
  const FlattenInput input = hills(6);
  CutTarget target;
  target.strain = 0;
  const std::vector<DartProposal> seams = plan_seams(input, {}, target);
  ASSERT_EQ(seams.size(), 2U);
  for (std::size_t i = 0; i < seams.size(); ++i) {
    EXPECT_NEAR(*seams[i].strain_left, most_strain(input, seams, i + 1), 1e-6 * seams[0].strain_before);
  }
}

TEST(PlanCuts, MirroredPairsAreChosenTogetherIfBothAreAllowed) {
  FlattenInput input = hills(8);
  // No dart crosses this wire, so no single dart can help both hills.
  test::add_wire(input, test::grid_column(8, 8, 4));
  CutTarget target;
  target.strain = 0;
  target.twins = true;
  const std::vector<DartProposal> both = plan_darts(input, {}, target);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].twin, 1);
  EXPECT_EQ(both[1].twin, 0);
  EXPECT_NEAR(both[0].length, both[1].length, 1e-9);
  EXPECT_NEAR(*both[0].strain_left, *both[0].strain_with_twin, 1e-6 * both[0].strain_before);
  EXPECT_EQ(both[0].strain_left, both[1].strain_left);
  EXPECT_NEAR(*both[0].strain_left, most_strain(input, both, 2), 1e-6 * both[0].strain_before);
  for (const bool is_number : {true, false}) {
    CutTarget less = target;
    if (is_number) less.most = 1;
    if (!is_number) less.total_length = 1.5 * both[0].length;
    const std::vector<DartProposal> cuts = plan_darts(input, {}, less);
    double length = 0;
    for (const DartProposal& cut : cuts) {
      if (is_number) {
        EXPECT_FALSE(cut.twin);
      }
      EXPECT_LT(cut.twin ? *cut.strain_with_twin : cut.strain, cut.strain_before);
      length += cut.length;
    }
    EXPECT_LE(static_cast<int>(cuts.size()), less.most);
    EXPECT_LE(length, less.total_length);
  }
}

/// Returns a sheet with a wide flat bulge, a small steep bulge and a seam between them. The wide bulge has the most
/// energy, and the steep bulge has the most strain.
FlattenInput bulges(int n) {
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double x = 6 * s - 2, y = 2 * t - 1;
    const auto bulge = [&](double at, double height, double sharpness) {
      return height * std::exp(-sharpness * ((x - at) * (x - at) + 2 * (y - 0.1) * (y - 0.1)));
    };
    return Eigen::Vector3d(x, y, bulge(1.8, 1.1, 0.6) + bulge(-1.1, 0.45, 6));
  });
  test::alternate_diagonals(input, n);
  test::add_seam(input, test::grid_column(n, n, n / 3));
  return input;
}

TEST(PlanCuts, CutThePieceWithTheMostStrainRatherThanTheMostEnergy) {
  const FlattenInput input = bulges(12);
  const FlattenResult uncut = flatten(input);
  std::vector<double> energies;
  for (const Piece& piece : uncut.pieces) energies.push_back(piece.metrics.arap_energy * piece.metrics.area_3d);
  CutTarget target;
  target.strain = 0;
  target.most = 1;
  const std::vector<DartProposal> cuts = plan_seams(input, {}, target);
  ASSERT_EQ(cuts.size(), 1U);
  const int other = 1 - cuts[0].piece;
  EXPECT_LT(energies[cuts[0].piece], energies[other]);
  EXPECT_LT(*cuts[0].strain_left, most_strain(input, {}, 0));
}

TEST(PlanCuts, OfOnePieceStayWithinIt) {
  const int n = 6;
  FlattenInput input = hills(n);
  test::add_seam(input, test::grid_column(n, n, n / 2));
  const std::vector<int> own = flatten(input).pieces[1].source_vertex;
  CutTarget target;
  target.strain = 0;
  target.most = 3;
  target.piece = 1;
  for (const DartProposal& cut : plan_seams(input, {}, target)) {
    for (const VertexPair& edge : cut.edges) {
      for (const int v : edge) EXPECT_GT(std::count(own.begin(), own.end(), v), 0);
    }
  }
}

TEST(PlanCuts, ProgressNeverFallsAndCanCancelInAnyRound) {
  CutTarget target;
  target.strain = 0;
  std::vector<double> fractions;
  plan_darts(hills(4), {}, target, [&](const std::string& stage, double fraction) {
    EXPECT_EQ(stage, "cuts");
    fractions.push_back(fraction);
    return true;
  });
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  const double second_round = 0.5;
  ASSERT_GE(fractions.back(), second_round);
  // The number of polls in this thread depends on how much work the other threads do. The test therefore cancels at a
  // fraction of the progress.
  for (const double last : {fractions.front(), second_round}) {
    bool has_ended = false;
    const auto plan = [&] {
      plan_darts(hills(4), {}, target, [&](const std::string&, double fraction) {
        EXPECT_FALSE(has_ended);
        has_ended = fraction >= last;
        return !has_ended;
      });
    };
    EXPECT_EQ(test::error_of(plan).code, ErrorCode::cancelled);
  }
}

}  // namespace
}  // namespace wirewarp::test_plan_cuts
