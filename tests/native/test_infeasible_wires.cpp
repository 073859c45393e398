// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that errors name wires that contradict one another, and suggest tolerances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/planar.h"
#include "energy/free_boundary_arap.h"
#include "error_of.h"
#include "newton/infeasible_wires.h"
#include "newton/project_to_lengths.h"
#include "newton/relax_lengths.h"
#include "newton/solve/chart_errors.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"

namespace wirewarp::test_infeasible_wires {
namespace {

/// Adds all inner rows and columns of an n by n grid as wires (a Chebyshev net). This net fixes fewer lengths than a
/// flat shape has degrees of freedom.
void add_lines(FlattenInput& input, int n, double tolerance) {
  for (int i = 1; i < n; ++i) test::add_net(input, n, {i}, tolerance);
}

std::vector<int> diagonal(int n, int offset) {
  std::vector<int> chain;
  for (int j = std::max(0, -offset); j <= n - std::max(0, offset); ++j) chain.push_back(j + offset + (n + 1) * j);
  return chain;
}

/// Returns whether a piece has exact lengths. Such a piece may be flipped or overlap itself.
bool has_exact_lengths(const Piece& piece) {
  return !piece.error || (piece.error->has_layout && piece.error->code != ErrorCode::lengths_not_kept);
}

bool is_refused(const Piece& piece) { return piece.error && piece.error->code == ErrorCode::infeasible_lengths; }

/// Expects that the input's piece has an error, and has no error with the suggested tolerances. Returns the piece with
/// the error.
Piece expect_fixed(FlattenInput input) {
  const Piece refused = flatten(input).pieces.at(0);
  EXPECT_TRUE(is_refused(refused));
  if (!is_refused(refused)) return refused;
  EXPECT_FALSE(refused.error->has_layout);
  const std::vector<ProposedTolerance>& proposed = refused.error->elements.proposed_tolerances;
  EXPECT_FALSE(proposed.empty());
  EXPECT_FALSE(refused.error->elements.edges.empty());
  for (const ProposedTolerance& p : proposed) {
    EXPECT_GT(p.tolerance, input.wires.at(p.wire).tolerance);
    input.wires.at(p.wire).tolerance = p.tolerance;
  }
  const Piece fixed = flatten(input).pieces.at(0);
  EXPECT_FALSE(fixed.error) << fixed.error->what();
  return refused;
}

TEST(InfeasibleWires, TolerancesFixACurvedPatchWithAWireOnEveryEdge) {
  FlattenInput sphere = test::quarter_sphere(4), saddle = test::saddle(5, 0.5);
  sphere.wires.clear();
  for (FlattenInput* input : {&sphere, &saddle}) {
    test::add_wires_on_edges(*input);
    expect_fixed(*input);
  }
}

TEST(InfeasibleWires, ADenseNetGetsOneToleranceForAll) {
  // To flatten a dome with a flat outline, changes of single wires are not enough. Every wire has a slope of at most
  // 0.2 π, so it is at most 18% longer than in the flat square.
  const int n = 6;
  FlattenInput input = test::make_grid(
      n, n, [](double s, double t) { return Eigen::Vector3d(s, t, 0.2 * std::sin(kPi * s) * std::sin(kPi * t)); });
  test::add_wires_on_edges(input);
  const Piece refused = expect_fixed(input);
  ASSERT_TRUE(refused.error);
  for (const ProposedTolerance& p : refused.error->elements.proposed_tolerances) {
    EXPECT_LT(p.tolerance, 0.1);  // much less than 18%
    EXPECT_EQ(p.tolerance, refused.error->elements.proposed_tolerances[0].tolerance);
  }
}

TEST(InfeasibleWires, OnlyWiresOfTheCurvedRegionAreNamed) {
  // The sheet is flat except for a dimple of radius 0.2. A wire needs a tolerance only if the angles at one of its ends
  // do not add up to 2π, as in the dimple.
  const int n = 10;
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double r2 = (s - 0.5) * (s - 0.5) + (t - 0.5) * (t - 0.5);
    return Eigen::Vector3d(s, t, r2 < 0.04 ? 0.04 * std::pow(1 - r2 / 0.04, 2) : 0);
  });
  test::add_wires_on_edges(
      input, 0, [](const Eigen::Vector3d& m) { return std::abs(m.x() - 0.5) + std::abs(m.y() - 0.5) < 0.5; });
  const Piece piece = expect_fixed(input);
  ASSERT_TRUE(piece.error);
  for (const ProposedTolerance& p : piece.error->elements.proposed_tolerances) {
    EXPECT_LE(p.tolerance, 0.2);
    for (const int v : input.wires[p.wire].vertices) {
      EXPECT_LT((input.vertices.row(v) - Eigen::RowVector3d(0.5, 0.5, 0)).norm(), 0.2 + 2 * std::sqrt(2) / n);
    }
  }
}

TEST(InfeasibleWires, TolerancesFixANetWithTooManyLines) {
  // Rows and columns can shear like a fishing net, even with one diagonal as a wire, but not with three diagonals.
  const int n = 8;
  for (const double tolerance : {0.0, 0.01}) {
    FlattenInput input = test::saddle(n, 0.3);
    add_lines(input, n, tolerance);
    test::add_wire(input, diagonal(n, 0));
    EXPECT_FALSE(is_refused(flatten(input).pieces.at(0)));
    for (const int offset : {3, -3}) test::add_wire(input, diagonal(n, offset));
    expect_fixed(input);
  }
}

TEST(InfeasibleWires, FeasibleNetsAreNotRefused) {
  // Half of the edges of a net of rows and columns are wires. They fix fewer lengths than a flat shape has degrees of
  // freedom, so they need not contradict one another.
  std::mt19937 random(7);
  const int n = 6;
  for (const int i : {0, 1, 4, 5, 10, 11}) {
    FlattenInput input = i % 2 == 0 ? test::saddle(n, 0.1 + 0.05 * i) : test::make_grid(n, n, [&](double s, double t) {
      const double x = s - 0.5, y = t - 0.5;
      return Eigen::Vector3d(x, y, std::sqrt(1 + 0.1 * i - x * x - y * y));
    });
    FlattenInput lines = input;
    add_lines(lines, n, 0);
    for (const Wire& line : lines.wires) {
      for (std::size_t k = 0; k + 1 < line.vertices.size(); ++k) {
        if (random() % 2 == 0) test::add_wire(input, {line.vertices[k], line.vertices[k + 1]});
      }
    }
    const Piece piece = flatten(input).pieces.at(0);
    EXPECT_TRUE(has_exact_lengths(piece)) << i << ": " << piece.error->what();
  }
}

TEST(RelaxedLengths, NoLengthChangesIfAllCanBeKept) {
  FlattenInput input = test::saddle(8, 0.4);
  add_lines(input, 8, 0);
  const Chart chart = test::chart_of(input);
  const Problem problem(chart, 0.1);
  Budget relax_budget(kMaxRelaxFactorizations);
  RelaxedShape relaxed = relax_lengths(problem, free_boundary_arap(chart, 30).uv, {relax_budget});
  // The last smoothing does not separate strains below 1e-4 from 0.
  EXPECT_LT(relaxed.tolerance_violation.maxCoeff(), 1e-4);
  EXPECT_LT(relaxed.strain_rms.maxCoeff(), 1e-4);
  EXPECT_LT(relaxed.outline_strain, 1e-4);
  const Positions2 untouched = relaxed.uv;
  Budget budget(kMaxProjectFactorizations);
  EXPECT_THROW(project_to_lengths(problem, relaxed.uv, {budget, StopToken([](const char*) { return false; })}),
               Stopped);
  EXPECT_EQ((relaxed.uv - untouched).norm(), 0);
  EXPECT_TRUE(project_to_lengths(problem, relaxed.uv, {budget}));
  for (const WireEdge& edge : problem.network().edges) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edge.edge, 0);
    EXPECT_NEAR(planar_length(chart.mesh, h, relaxed.uv), edge.length, 1e-11 * edge.length);
  }
}

TEST(RelaxedLengths, TolerancesOfSingleEdgesCostNothing) {
  // Each wire is one edge that may change its length by half, so only the outline keeps its length.
  FlattenInput input = test::saddle(6, 0.4);
  const Positions2 free = free_boundary_arap(test::chart_of(input), 30).uv;
  test::add_wires_on_edges(input, 0.5);
  Budget budget(kMaxRelaxFactorizations);
  const RelaxedShape relaxed = relax_lengths({test::chart_of(input), 0.1}, free, {budget});
  EXPECT_EQ(relaxed.tolerance_violation.maxCoeff(), 0);
  EXPECT_LT(relaxed.outline_strain, 1e-4);  // the last smoothing does not separate smaller strains from 0
}

TEST(RelaxedLengths, StopsWhenAsked) {
  const Chart chart = test::chart_of(test::quarter_sphere(4));
  const Positions2 start = free_boundary_arap(chart, 30).uv;
  int asked = 0;
  // Stops at the third poll, during the first step. The constructor of NewtonSystem polls twice.
  const StopToken stop([&](const char*) { return ++asked < 3; });
  Budget budget(kMaxRelaxFactorizations);
  EXPECT_THROW(relax_lengths({chart, 0.1}, start, {budget, stop}), Stopped);
  EXPECT_EQ(budget.spent(), 1);
  EXPECT_EQ(asked, 3);
}

TEST(InfeasibleWires, ThePapersMethodsProposeTolerancesForTheRefinedMethod) {
  const FlattenInput input = test::saddle_of_wires(4, 0);
  for (const Method method : {Method::wirewarping, Method::wirewarp_plus_plus}) {
    Options options = test::by(method);
    const Piece refused = flatten(input, options).pieces.at(0);
    ASSERT_TRUE(is_refused(refused));
    test::expect_words(*refused.error, "by the refined method");
    ASSERT_FALSE(refused.error->elements.proposed_tolerances.empty());
    FlattenInput looser = input;
    for (const ProposedTolerance& p : refused.error->elements.proposed_tolerances) {
      looser.wires.at(p.wire).tolerance = p.tolerance;
    }
    const Piece fixed = flatten(looser).pieces.at(0);
    EXPECT_TRUE(has_exact_lengths(fixed)) << fixed.error->what();
    if (method != Method::wirewarping) continue;
    const Piece still_rigid = flatten(looser, options).pieces.at(0);  // this method ignores tolerances
    ASSERT_TRUE(is_refused(still_rigid));
    test::expect_words(*still_rigid.error, "use the refined method");
  }
}

TEST(InfeasibleWires, ALongerSearchIsAdvisedOnlyIfTheLengthsDoNotContradictOneAnother) {
  const auto conflict = [](const FlattenInput& input) {
    const Chart chart = test::chart_of(input);
    Problem problem(chart, Options{}.fairness);
    return diagnose_lengths(problem, {}, {}).lengths_conflict;
  };
  EXPECT_TRUE(conflict(test::saddle_of_wires(4, 0)));
  EXPECT_FALSE(conflict(test::quarter_sphere(4)));
  const Chart chart = test::chart_of(test::quarter_sphere(4));
  Options options;
  options.max_factorizations = 7;
  const std::string advice = "max_factorizations = 7: raise it";
  const auto sentence = [&](bool ran_out) {
    return std::string(infeasible_outline(chart, options, {}, ran_out).what());
  };
  test::expect_words(sentence(true), advice);
  EXPECT_EQ(sentence(false).find("max_factorizations"), std::string::npos) << sentence(false);
  test::expect_words(infeasible_stretch(chart, options, {}, true, true), advice);
}

TEST(InfeasibleWires, LessStretchIsAdvisedOnlyIfThePieceIsGoodWithoutIt) {
  const Chart chart = test::chart_of(test::quarter_sphere(4));
  const auto sentence = [&](bool is_good_unstretched) {
    return std::string(infeasible_stretch(chart, {}, {}, is_good_unstretched, false).what());
  };
  test::expect_words(sentence(true), "use less stretch, or mark a seam");
  EXPECT_EQ(sentence(false).find("less stretch"), std::string::npos) << sentence(false);
  test::expect_words(sentence(false), "mark a seam");
}

}  // namespace
}  // namespace wirewarp::test_infeasible_wires
