// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of sets of seams that are suggested for models without seams. A run with the seams must confirm their figures.
// The sets must not depend on position, orientation and numbering.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "closed_meshes.h"
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

/// Returns options for few cuts, which are quick to find.
CutOptions rough() {
  CutOptions cut_options;
  cut_options.strain = 0.3;
  return cut_options;
}

struct Case {
  const char* name;
  FlattenInput input;
};

/// Names the case in test reports.
void PrintTo(const Case& shape, std::ostream* out) { *out << shape.name; }

class SeamSetsOf : public testing::TestWithParam<Case> {};

TEST_P(SeamSetsOf, FlattenEveryPieceWithTheFiguresOfAFreshRun) {
  const FlattenInput& input = GetParam().input;
  CutOptions cut_options;
  cut_options.strain = 0.15;
  const std::vector<DartProposal> sets = propose_seams(input, {}, cut_options);
  ASSERT_FALSE(sets.empty());
  EXPECT_LE(sets.front().strain, *cut_options.strain);
  for (const DartProposal& set : sets) {
    test::expect_figures(test::with_seams(input, set.edges), {set.energy, set.strain, set.length, set.num_pieces});
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

INSTANTIATE_TEST_SUITE_P(Shapes, SeamSetsOf,
                         testing::Values(Case{"ball", ball()}, Case{"head", head()}, Case{"lopsided_head", head(0.5)},
                                         Case{"hill", hill()}, Case{"torus", test::closed_torus(18, 9)},
                                         Case{"tube", test::cylinder_tube(16, 8, 1, 4)}),
                         [](const testing::TestParamInfo<Case>& test) { return std::string(test.param.name); });

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
  VertexPairs rows(static_cast<Eigen::Index>(edges.size()), 2);
  Eigen::Index row = 0;
  for (const VertexPair& edge : edges) rows.row(row++) << edge[1], edge[0];  // in the reverse direction
  return rows;
}

TEST(CutSetSearch, AvoidsEdgesThatMayHaveNoSeam) {
  for (const FlattenInput& input : {ball(), head(0.5)}) {
    CutOptions cut_options = rough();
    const std::set<VertexPair> forbidden = test::undirected(propose_seams(input, {}, cut_options).front().edges);
    cut_options.no_seam = as_rows(forbidden);
    for (const DartProposal& set : propose_seams(input, {}, cut_options)) {
      for (const VertexPair& edge : test::undirected(set.edges)) EXPECT_EQ(forbidden.count(edge), 0U);
    }
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
      test::expect_figures(test::with_seams(input, set.edges), {set.energy, set.strain, set.length, set.num_pieces});
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

}  // namespace
}  // namespace wirewarp::test_cut_sets
