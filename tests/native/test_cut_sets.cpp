// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of sets of seams that are suggested for models without seams, and of plans of several cuts.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "closed_meshes.h"
#include "cuts/propose/cut_sets.h"
#include "disguise.h"
#include "error_of.h"
#include "judge_cuts.h"
#include "test_meshes.h"
#include "wirewarp/propose.h"

namespace wirewarp::test_cut_sets {
namespace {

/// Returns a closed surface whose diagonals are mirrored across y = 0.
FlattenInput closed(int around, int rings, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& shape) {
  return test::closed_surface(around, rings, shape,
                              [around](int i, int j) { return (i < around / 2) == (j % 2 == 0); });
}

FlattenInput ball() {
  return closed(12, 10, [](const Eigen::Vector3d& p) { return p; });
}

/// Returns the plush head of an animal with two ears. The head is symmetric across y = 0 if tilt, the y of the snout,
/// is 0.
FlattenInput head(double tilt = 0) {
  return closed(12, 8, [tilt](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const Eigen::Vector3d ear(-0.1, 0.6, 0.8);
    const double ears = std::exp(-8 * (Eigen::Vector3d(p.x(), std::abs(p.y()), p.z()) - ear).squaredNorm());
    const double snout = std::exp(-6 * (p - Eigen::Vector3d(1, tilt, -0.2)).squaredNorm());
    return (1 + 0.3 * ears + 0.4 * snout) * Eigen::Vector3d(p.x(), 0.9 * p.y(), 0.8 * p.z());
  });
}

/// Returns an open surface whose flat shape needs more than 100% of stretch.
FlattenInput hill() {
  return test::height_field(8, [](double x, double y) { return 2 * (1 - x * x) * (1 - y * y); });
}

CutOptions rough() {
  CutOptions cut_options;
  cut_options.strain = 0.3;
  return cut_options;
}

/// Expects that the suggested sets of seams flatten every piece with the claimed figures, and that shorter sets leave
/// more strain.
void expect_true_sets(const FlattenInput& input) {
  CutOptions cut_options;
  cut_options.strain = 0.15;
  const std::vector<DartProposal> sets = propose_seams(input, {}, cut_options);
  ASSERT_FALSE(sets.empty());
  EXPECT_LE(sets.front().strain, *cut_options.strain);
  for (const DartProposal& set : sets) {
    test::expect_figures(input, set);
    EXPECT_EQ(set.energy_before, std::numeric_limits<double>::infinity());
    EXPECT_EQ(set.strain_before, std::numeric_limits<double>::infinity());
    EXPECT_EQ(set.piece, 0);
    EXPECT_FALSE(set.twin);
  }
  for (std::size_t i = 1; i < sets.size(); ++i) {
    EXPECT_GT(sets[i].strain, sets[i - 1].strain);
    EXPECT_LT(sets[i].length, sets[i - 1].length);
    EXPECT_LE(sets[i].num_pieces, sets[i - 1].num_pieces);
  }
}

TEST(CutSetSearch, ReportsProgressThatNeverFallsAndIsNotStuckAtTheEnd) {
  std::vector<double> reported;
  propose_seams(head(), {}, rough(), [&](const std::string&, double fraction) {
    reported.push_back(fraction);
    return true;
  });
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_LT(reported.back(), 1);
  EXPECT_LT(reported[reported.size() / 2], 0.9);
}

TEST(SeamSets, OfABallAreTrue) { expect_true_sets(ball()); }
TEST(SeamSets, OfAHeadAreTrue) { expect_true_sets(head()); }
TEST(SeamSets, OfALopsidedHeadAreTrue) { expect_true_sets(head(0.5)); }
TEST(SeamSets, OfAHillAreTrue) { expect_true_sets(hill()); }
TEST(SeamSets, OfATorusAreTrue) { expect_true_sets(test::closed_torus(18, 9)); }
TEST(SeamSets, OfATubeAreTrue) { expect_true_sets(test::cylinder_tube(16, 8, 1, 4)); }

TEST(CutSetSearch, MakesNoSetForAPieceThatAWireStrains) {
  FlattenInput input = hill();
  test::add_wire(input, test::grid_column(8, 8, 4));
  test::expect_words(test::error_of([&] { propose_seams(input); }), "give its wires more tolerance");
}

TEST(CutSetSearch, DoesNotDependOnPositionOrientationAndNumbering) {
  const FlattenInput input = head(0.5);
  const FlattenInput other = test::disguised(input);
  const std::vector<DartProposal> here = propose_seams(input, {}, rough()), there = propose_seams(other, {}, rough());
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(test::undirected(test::disguised(input, here[i].edges)), test::undirected(there[i].edges));
    EXPECT_NEAR(here[i].energy, there[i].energy, 1e-6 * here[i].energy);
    EXPECT_NEAR(here[i].strain, there[i].strain, 1e-5 * here[i].strain);
  }
}

TEST(CutSetSearch, FindsSymmetricSeamsOfASymmetricModel) {
  const FlattenInput input = head();
  for (const DartProposal& set : propose_seams(input, {}, rough())) {
    std::vector<VertexPair> image;
    for (const VertexPair& edge : set.edges) {
      VertexPair opposite{};
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const Eigen::Vector3d p = input.vertices.row(edge[end]);
        opposite[end] = test::nearest_vertex(input, {p.x(), -p.y(), p.z()});
      }
      image.push_back(opposite);
    }
    EXPECT_EQ(test::undirected(image), test::undirected(set.edges));
  }
}

VertexPairs as_rows(const std::set<VertexPair>& edges) {
  VertexPairs rows(edges.size(), 2);
  Eigen::Index row = 0;
  for (const VertexPair& edge : edges) rows.row(row++) << edge[1], edge[0];  // in the reverse direction
  return rows;
}

TEST(CutSetSearch, AvoidsEdgesThatMayHaveNoSeam) {
  const FlattenInput input = head(0.5);
  CutOptions cut_options = rough();
  const std::set<VertexPair> forbidden = test::undirected(propose_seams(input, {}, cut_options).front().edges);
  cut_options.no_seam = as_rows(forbidden);
  for (const DartProposal& set : propose_seams(input, {}, cut_options)) {
    for (const VertexPair& edge : test::undirected(set.edges)) EXPECT_EQ(forbidden.count(edge), 0U);
  }
}

TEST(CutSetSearch, SetsAreNoLongerThanAllowed) {
  CutOptions cut_options = rough();
  const std::vector<DartProposal> sets = propose_seams(head(), {}, cut_options);
  ASSERT_GT(sets.size(), 1U);
  cut_options.longest = sets.front().length * (1 - 1e-9);
  for (const DartProposal& set : propose_seams(head(), {}, cut_options)) EXPECT_LE(set.length, cut_options.longest);
}

TEST(CutSetSearch, ReturnsASetThatMeetsTheTargetFirst) {
  CutOptions cut_options = rough();
  const std::vector<DartProposal> sets = propose_seams(head(), {}, cut_options);
  ASSERT_GT(sets.size(), 1U);
  cut_options.strain = 0.99 * sets[1].strain;  // a target that sets[1] misses by 1%
  EXPECT_LE(propose_seams(head(), {}, cut_options).front().strain, *cut_options.strain);
}

std::vector<DartProposal> search_sets(const FlattenInput& input, const CutOptions& cut_options,
                                      const MostCuts& most_cuts = {}) {
  const Progress no_progress;
  CutProgress progress(no_progress);
  const InternalOptions options;
  const SurfaceToCut surface(input, options);
  const ExactEvaluation exact(surface, options, progress.token());
  return CutSetSearch(exact.uncut(), 0, cut_options, exact, progress, most_cuts).search();
}

TEST(CutSetSearch, MakesMoreCutsForPlushAndForARequestedStrain) {
  const FlattenInput input = head(0.5);
  EXPECT_GT(search_sets(input, {}, {1, 1}).front().strain, kSoftStrain);
  const double for_plush = search_sets(input, {}, {1, 80}).front().strain;
  EXPECT_LE(for_plush, kSoftStrain);
  EXPECT_GT(for_plush, kTargetStrain);
  CutOptions cut_options;
  cut_options.strain = 0.9 * for_plush;
  EXPECT_LE(search_sets(input, cut_options, {1, 80}).front().strain, *cut_options.strain);
}

TEST(CutSetSearch, FindsSmoothSetsWithTheRequestedStrain) {
  CutOptions cut_options;
  cut_options.is_smooth = true;
  cut_options.strain = 0.08;
  const DartProposal first = search_sets(head(), cut_options).front();
  EXPECT_FALSE(first.paths.empty());
  EXPECT_LE(first.strain, *cut_options.strain);
}

TEST(CutSetSearch, SuggestsSeamsForThePieceThatNeedsSeams) {
  const FlattenInput both = test::beside(test::flat_rectangle(2, 2, 1, 1), test::cylinder_tube(8, 4, 1, 4), 5);
  EXPECT_EQ(propose_seams(both, {}, rough()).front().piece, 1);
}

std::string refusal(const FlattenInput& input, const CutOptions& cut_options) {
  const FlattenError error = test::error_of([&] { propose_seams(input, {}, cut_options); });
  EXPECT_EQ(error.code, ErrorCode::no_proposal);
  return error.what();
}

TEST(CutSetSearch, ReportsWhyThereAreNoSeams) {
  const FlattenInput input = ball();
  CutOptions cut_options = rough();
  cut_options.longest = 0.1;
  test::expect_words(refusal(input, cut_options), "can be flattened with seams of ");
  cut_options = rough();
  std::vector<VertexPair> all;
  for (Eigen::Index f = 0; f < input.faces.rows(); ++f) {
    for (Eigen::Index k = 0; k < 3; ++k) all.push_back({input.faces(f, k), input.faces(f, (k + 1) % 3)});
  }
  cut_options.no_seam = as_rows(test::undirected(all));
  test::expect_words(refusal(input, cut_options), "No set of seams along edges that may have a seam was found");
}

TEST(CutSetSearch, CanBeCanceledBeforeTheFirstSet) {
  int asked = 0;
  const auto propose = [&] { propose_seams(head(), {}, {}, [&](const std::string&, double) { return ++asked < 5; }); };
  EXPECT_EQ(test::error_of(propose).code, ErrorCode::cancelled);
  EXPECT_EQ(asked, 5);
}

TEST(CutSetSearch, ReturnsTheSetsFoundSoFarIfStopped) {
  const FlattenInput input = head();
  for (const double share : {0.5, 0.9}) {
    double last = 0;
    const auto stop = [&](const std::string&, double reached) {
      last = reached;
      return reached < share;
    };
    const std::vector<DartProposal> sets = propose_seams(input, {}, {}, stop);
    EXPECT_LT(last, share + 0.1);
    ASSERT_FALSE(sets.empty());
    for (const DartProposal& set : sets) {
      EXPECT_EQ(set.piece, 0);
      test::expect_figures(input, set);
    }
  }
}

TEST(CutSetSearch, APlanIsCanceledWithItsSets) {
  CutTarget target;
  target.most = 1;
  const auto stop = [](const std::string&, double reached) { return reached < 0.5; };
  const auto plan = [&] { plan_seams(head(), {}, target, stop); };
  EXPECT_EQ(test::error_of(plan).code, ErrorCode::cancelled);
}

FlattenInput hills(int n) { return test::two_hills(n, 1.1); }

/// Returns the strain of the most strained piece with the first num_cuts of these cuts.
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
      EXPECT_FALSE(cut.twin && is_number);
      EXPECT_LT(cut.twin ? *cut.strain_with_twin : cut.strain, cut.strain_before);
      length += cut.length;
    }
    EXPECT_LE(static_cast<int>(cuts.size()), less.most);
    EXPECT_LE(length, less.total_length);
  }
}

/// Returns a sheet with a wide bulge, a small steep bulge and a seam between them. The wide bulge has the most energy,
/// and the steep bulge has the most strain.
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
  // fraction of the progress, not at a number of polls.
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
}  // namespace wirewarp::test_cut_sets
