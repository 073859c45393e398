// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of suggested darts and seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "disguise.h"
#include "error_of.h"
#include "judge_cuts.h"
#include "test_meshes.h"
#include "wirewarp/propose.h"

namespace wirewarp::test_propose_cuts {
namespace {

/// Returns an n by n grid with all diagonals in one direction, so that its faces have no mirror images.
FlattenInput one_way(FlattenInput input, int n) {
  input.faces = test::flat_rectangle(n, n, 1, 1).faces;
  return input;
}

CutOptions few() {
  CutOptions cut_options;
  cut_options.count = 2;
  return cut_options;
}

double figure_of(const DartProposal& proposal) { return proposal.strain_with_twin.value_or(proposal.strain); }

TEST(ProposeCuts, SmoothDartsHaveTheFiguresOfTheMeshCutAlongThem) {
  const FlattenInput input = test::hill(8);
  CutOptions cut_options = few();
  cut_options.is_smooth = true;
  const std::vector<DartProposal> proposals = propose_darts(input, {}, cut_options);
  ASSERT_FALSE(proposals.empty());
  for (const DartProposal& proposal : proposals) {
    EXPECT_FALSE(proposal.paths.empty());
    test::expect_figures(input, proposal);
  }
}

TEST(ProposeCuts, TheBestSmoothDartIsAtMostSlightlyWorseThanTheBestAlongEdges) {
  for (const FlattenInput& input : {test::hill(8), one_way(test::two_hills(8), 8)}) {
    CutOptions cut_options = few();
    const double along_edges = figure_of(propose_darts(input, {}, cut_options).front());
    cut_options.is_smooth = true;
    const std::vector<DartProposal> proposals = propose_darts(input, {}, cut_options);
    EXPECT_LE(0.95 * figure_of(proposals.front()), along_edges * (1 + 1e-9));
    for (std::size_t i = 0; i < proposals.size(); ++i) {
      if (proposals[i].twin) {
        EXPECT_EQ(proposals[*proposals[i].twin].twin, static_cast<int>(i));
      }
      EXPECT_LT(figure_of(proposals[i]), proposals[i].strain_before);
    }
  }
}

TEST(ProposeCuts, HaveTheFiguresOfAFreshRun) {
  const FlattenInput input = test::hill(6);
  for (const auto& propose : {propose_darts, propose_seams}) {
    const std::vector<DartProposal> proposals = propose(input, {}, few(), {});
    ASSERT_FALSE(proposals.empty());
    const double before = test::energy_of(flatten(input));
    for (const DartProposal& cut : proposals) {
      test::expect_figures(input, cut);
      EXPECT_NEAR(cut.energy_before, before, 1e-6 * before);
      EXPECT_LT(cut.energy, cut.energy_before);
      EXPECT_EQ(cut.num_pieces, propose == propose_darts ? 1 : 2);
    }
    EXPECT_TRUE(std::is_sorted(proposals.begin(), proposals.end(), [](const DartProposal& a, const DartProposal& b) {
      return figure_of(a) < figure_of(b);
    }));
  }
}

/// Returns a wide sheet with a sharp bump in a corner. A seam beside the bump does not help the piece with the bump.
FlattenInput bump_in_a_corner(int n) {
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    return Eigen::Vector3d(s, t, 0.15 * std::exp(-30 * ((s - 0.2) * (s - 0.2) + (t - 0.25) * (t - 0.25))));
  });
  test::alternate_diagonals(input, n);
  return input;
}

TEST(ProposeCuts, EveryProposalLowersTheStrainOfTheWorstPiece) {
  for (const FlattenInput& input : {bump_in_a_corner(10), test::two_hills(8, 1.1)}) {
    const double before = test::most_strain(input, flatten(input));
    for (const auto& propose : {propose_darts, propose_seams}) {
      const std::vector<DartProposal> proposals = propose(input, {}, few(), {});
      EXPECT_FALSE(proposals.empty());
      for (const DartProposal& cut : proposals) {
        FlattenInput after = test::with_seams(input, cut.edges);
        if (cut.strain_with_twin) after = test::with_seams(after, proposals[*cut.twin].edges);
        const double strain = test::most_strain(after, flatten(after));
        EXPECT_NEAR(figure_of(cut), strain, 1e-6);
        EXPECT_LT(strain, 0.99 * before);
      }
    }
  }
}

TEST(ProposeCuts, NoProposalLeavesAPieceWithOver100PercentStrain) {
  const FlattenInput spike = test::height_field(
      8, [](double x, double y) { return 3 * std::exp(-4 * ((x - 0.2) * (x - 0.2) + (y + 0.1) * (y + 0.1))); });
  ASSERT_GT(test::most_strain(spike, flatten(spike)), 1);
  CutOptions all;
  all.count = 50;  // so many that darts which leave a strain of 117% would be returned, too
  for (const auto& propose : {propose_darts, propose_seams}) {
    const std::vector<DartProposal> proposals = propose(spike, {}, all, {});
    EXPECT_FALSE(proposals.empty());
    for (const DartProposal& cut : proposals) EXPECT_LT(figure_of(cut), 1);
  }
}

std::string refusal(const FlattenInput& input, const CutOptions& cut_options = {}) {
  const FlattenError error = test::error_of([&] { propose_darts(input, {}, cut_options); });
  EXPECT_EQ(error.code, ErrorCode::no_proposal);
  return error.what();
}

TEST(ProposeCuts, DartsThatDoNotHelpAreRefusedInOneSentence) {
  // A dart keeps the lengths of the outline beside it, and removes the shear of at most half of the saddle. So no dart
  // gains enough to be listed.
  const FlattenInput saddle = test::height_field(4, [](double x, double y) { return 0.2 * x * y; });
  CutOptions cut_options;
  cut_options.longest = 0.51;  // one edge
  test::expect_words(refusal(saddle, cut_options), "Divide it by a seam");
}

TEST(ProposeCuts, DoNotDependOnPositionOrientationAndNumbering) {
  const FlattenInput input = test::hill(8);
  const FlattenInput other = test::disguised(input);
  const std::vector<DartProposal> here = propose_darts(input, {}, few()), there = propose_darts(other, {}, few());
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(test::disguised(input, here[i].edges), there[i].edges);
    EXPECT_NEAR(here[i].energy, there[i].energy, 1e-6 * here[i].energy_before);
  }
}

TEST(ProposeCuts, DartsOfASymmetricPieceHaveMirrorImages) {
  const FlattenInput input = test::two_hills(8);
  const std::vector<DartProposal> darts = propose_darts(input, {}, few());
  int num_twins = 0;
  for (std::size_t i = 0; i < darts.size(); ++i) {
    if (!darts[i].twin) continue;
    const DartProposal& twin = darts[*darts[i].twin];
    EXPECT_EQ(twin.twin, static_cast<int>(i));
    EXPECT_NEAR(twin.energy, darts[i].energy, 1e-6 * twin.energy_before);
    ++num_twins;
    ASSERT_EQ(twin.edges.size(), darts[i].edges.size());
    for (std::size_t k = 0; k < twin.edges.size(); ++k) {
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const Eigen::Vector3d p = input.vertices.row(darts[i].edges[k][end]),
                              q = input.vertices.row(twin.edges[k][end]);
        EXPECT_NEAR((p - Eigen::Vector3d(-q.x(), q.y(), q.z())).norm(), 0, 1e-12);
      }
    }
  }
  EXPECT_GT(num_twins, 0);
}

TEST(ProposeCuts, MirrorImagesThatDoNotMeetHaveTheFiguresOfBoth) {
  const FlattenInput input = test::two_hills(8, 1.1);
  const std::vector<DartProposal> darts = propose_darts(input);
  int num_together = 0;
  for (const DartProposal& dart : darts) {
    if (!dart.energy_with_twin) continue;
    ++num_together;
    const DartProposal& twin = darts[*dart.twin];
    EXPECT_EQ(twin.energy_with_twin, dart.energy_with_twin);
    EXPECT_EQ(twin.strain_with_twin, dart.strain_with_twin);
    const FlattenResult both = flatten(test::with_seams(test::with_seams(input, dart.edges), twin.edges));
    EXPECT_EQ(both.pieces.size(), 1U);
    EXPECT_NEAR(*dart.energy_with_twin, test::energy_of(both), 1e-6 * dart.energy_before);
    EXPECT_LT(*dart.energy_with_twin, dart.energy);
  }
  EXPECT_GT(num_together, 0);
}

TEST(ProposeCuts, DoNotCutWires) {
  const int n = 6;
  for (FlattenInput input : {test::hill(n), test::two_hills(n)}) {  // the wire is on one side of the symmetric piece
    test::add_wire(input, test::grid_column(n, n, 4));
    const std::vector<int>& wire = input.wires[0].vertices;
    for (const auto& propose : {propose_darts, propose_seams}) {
      for (const DartProposal& cut : propose(input, {}, few(), {})) {
        for (const VertexPair& edge : cut.edges) {
          for (const int v : edge) EXPECT_EQ(std::count(wire.begin() + 1, wire.end() - 1, v), 0);
        }
      }
    }
  }
}

TEST(ProposeCuts, AvoidEdgesThatMayHaveNoSeam) {
  for (const FlattenInput& input : {test::hill(6), test::two_hills(6)}) {
    for (const auto& propose : {propose_darts, propose_seams}) {
      CutOptions cut_options = few();
      // Forbids only the edges of the best suggestion.
      const std::vector<VertexPair> forbidden = propose(input, {}, cut_options, {}).front().edges;
      cut_options.no_seam.resize(forbidden.size(), 2);
      for (std::size_t i = 0; i < forbidden.size(); ++i) {
        const auto [end, begin] = forbidden[i];  // either direction forbids the edge
        cut_options.no_seam.row(i) << begin, end;
      }
      const std::set<VertexPair> avoided = test::undirected(forbidden);
      for (const DartProposal& cut : propose(input, {}, cut_options, {})) {
        for (const VertexPair& edge : test::undirected(cut.edges)) EXPECT_EQ(avoided.count(edge), 0U);
      }
    }
  }
}

VertexPairs all_edges(const Triangles& faces) {
  VertexPairs edges(3 * faces.rows(), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (Eigen::Index k = 0; k < 3; ++k) edges.row(3 * f + k) << faces(f, k), faces(f, (k + 1) % 3);
  }
  return edges;
}

TEST(ProposeCuts, KeepTheLimitsOnLengthAndNumber) {
  CutOptions cut_options = few();
  cut_options.longest = 0.5;
  const std::vector<DartProposal> darts = propose_darts(test::hill(8), {}, cut_options);
  EXPECT_LE(darts.size(), 2U);
  for (const DartProposal& dart : darts) EXPECT_LE(dart.length, cut_options.longest);
}

TEST(ProposeCuts, OneSmoothDartOrPairIsReturnedIfOneIsAskedFor) {
  for (const FlattenInput& input : {test::hill(6), test::two_hills(6), bump_in_a_corner(10)}) {
    CutOptions cut_options;
    cut_options.is_smooth = true;
    cut_options.count = 1;
    const std::vector<DartProposal> darts = propose_darts(input, {}, cut_options);
    ASSERT_FALSE(darts.empty());
    EXPECT_EQ(darts.size(), darts.front().twin ? 2U : 1U);
    for (const DartProposal& dart : darts) EXPECT_LT(figure_of(dart), dart.strain_before);
  }
}

TEST(ProposeCuts, AreAlmostAsGoodAsAnExhaustiveSearch) {
  const int n = 6;
  const FlattenInput input = test::hill(n);
  double best = 1;
  for (int i = 1; i < n; ++i) {  // darts along all rows and columns
    for (int length = 1; length < n; ++length) {
      for (const bool reversed : {false, true}) {
        for (std::vector<int> line : {test::grid_row(n, i), test::grid_column(n, n, i)}) {
          if (reversed) std::reverse(line.begin(), line.end());
          FlattenInput cut = input;
          test::add_seam(cut, test::section(line, 0, length));
          const FlattenResult result = flatten(cut);
          if (!result.pieces[0].error) best = std::min(best, test::energy_of(result));
        }
      }
    }
  }
  const DartProposal found = propose_darts(input).front();
  EXPECT_LE(found.energy - best, 0.1 * (found.energy_before - best));
}

TEST(ProposeCuts, ErrorsReportWhyThereAreNoDarts) {
  test::expect_words(refusal(test::cylinder_patch(6, 4, 1, 2, 1)), "is flat enough");
  const FlattenInput strip = test::keep_faces(test::hill(4), [](const Eigen::Vector3d& p) { return p.x() > 0.5; });
  test::expect_words(refusal(strip), "is unfolded without distortion");  // no vertex inside
  FlattenInput crossed = test::hill(2);
  test::add_wire(crossed, test::grid_column(2, 2, 1));
  test::expect_words(refusal(crossed), "has no room for a dart");  // the only vertex inside is on a wire
  CutOptions nowhere;
  nowhere.no_seam = all_edges(test::hill(4).faces);
  test::expect_words(refusal(test::hill(4), nowhere), "No line along edges that may have a seam leads");
}

TEST(CutSearches, RefuseOptionsOutOfRange) {
  const FlattenInput input = test::hill(4);
  const auto darts = [&](const std::function<void(CutOptions&)>& change) {
    CutOptions cut_options;
    change(cut_options);
    return test::error_of([&] { propose_darts(input, {}, cut_options); });
  };
  const auto beside = [&](int other) {  // vertex 24 is the opposite corner, and vertex 25 does not exist
    return darts([&](CutOptions& options) { options.no_seam = (VertexPairs(1, 2) << 0, other).finished(); });
  };
  const auto plan = [&](const std::function<void(CutTarget&)>& change) {
    CutTarget target;
    change(target);
    return test::error_of([&] { plan_darts(input, {}, target); });
  };
  const std::string no_piece = "piece is 1: it must be from 0 to 0, as the mesh has 1 piece.";
  const std::vector<std::pair<FlattenError, std::string>> refused{
      {darts([](CutOptions& options) { options.piece = 1; }), no_piece},
      {darts([](CutOptions& options) { options.count = 0; }), "count is 0: it must be 1 or more."},
      {darts([](CutOptions& options) { options.longest = -1; }), "longest is -1: it must be above 0."},
      {beside(24), "no_seam is a list with the pair 0, 24: it must contain edges of the mesh only."},
      {beside(25), "no_seam is a list with the pair 0, 25: it must contain edges of the mesh only."},
      {plan([](CutTarget& target) { target.most = 0; }), "most is 0: it must be at least 1."},
      {plan([](CutTarget& target) { target.total_length = 0; }), "total_length is 0: it must be above 0."},
      {plan([](CutTarget& target) { target.strain = -1; }), "strain is -1: it must be 0 or more."},
      {plan([](CutTarget& target) { target.piece = 1; }), no_piece},
      {test::error_of([&] { simplify_seams(input, {}, -0.1); }), "strain is -0.1: it must be 0 or more."},
  };
  for (const auto& [error, sentence] : refused) {
    EXPECT_EQ(error.code, ErrorCode::invalid_option);
    EXPECT_EQ(error.what(), "The option " + sentence);
  }
}

TEST(ProposeCuts, ThrowTheErrorOfAPieceThatCannotBeFlattened) {
  const FlattenInput tube = test::cylinder_tube(12, 6, 1, 6);
  const FlattenError expected = flatten(tube).pieces[0].error.value();
  std::string stages;
  double before = 0;
  const FlattenError error = test::error_of([&] {
    propose_darts(tube, {}, {}, [&](const std::string& stage, double fraction) {
      EXPECT_GE(fraction, before);
      before = fraction;
      if (stages.find(stage) == std::string::npos) stages += stage;
      return true;
    });
  });
  EXPECT_EQ(error.code, ErrorCode::boundary_too_short);
  EXPECT_STREQ(error.what(), expected.what());
  EXPECT_EQ(error.elements.proposed_seams, expected.elements.proposed_seams);
  EXPECT_EQ(stages, "cuts");
}

}  // namespace
}  // namespace wirewarp::test_propose_cuts
