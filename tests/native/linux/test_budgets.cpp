// SPDX-License-Identifier: GPL-3.0-or-later
// Limits the work in the inner loops and after a cancellation, in counts of allocations and substitutions instead of
// seconds. Other files limit the factorizations and evaluations of each algorithm.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cholesky_problems.h"
#include "count_allocations.h"
#include "count_fronts.h"
#include "energy/free_boundary_arap.h"
#include "error_of.h"
#include "flatten.h"
#include "newton/minimize.h"
#include "newton/newton_system.h"
#include "newton/starts.h"
#include "numerics/cholesky/multifrontal_cholesky.h"
#include "test_meshes.h"
#include "warp/outer/warp.h"

namespace wirewarp::test_budgets {
namespace {

FlattenInput sheet(int n) {
  FlattenInput input = test::saddle(n, 0.3);
  test::add_wire(input, test::grid_row(n, n / 2));
  test::add_wire(input, test::grid_column(n, n, n / 2), 0.05);
  return input;
}

template <typename Work>
int allocations_of(const Work& work) {
  const int before = num_allocations();
  work();
  return num_allocations() - before;
}

struct SheetToFlatten {
  explicit SheetToFlatten(int n) : chart(test::chart_of(sheet(n))), uv(free_boundary_arap(chart, 30).uv) {}

  Chart chart;
  Positions2 uv;
};

TEST(Budgets, AllocationsOfEigenAreCounted) {
  EXPECT_EQ(allocations_of([] { Eigen::VectorXd::Zero(1000).eval(); }), 1);
  EXPECT_EQ(allocations_of([] { std::vector<int>(1000); }), 1);
}

TEST(Budgets, TheShapeErrorAllocatesNothing) {
  const SheetToFlatten flat(8);
  const ShapeError shape_error(flat.chart);
  Positions2 gradient;
  shape_error.energy_and_gradient(flat.uv, gradient);
  EXPECT_EQ(allocations_of([&] { shape_error.energy(flat.uv); }), 0);
  EXPECT_EQ(allocations_of([&] { shape_error.energy_and_gradient(flat.uv, gradient); }), 0);
}

TEST(Budgets, AFactorizationAllocatesNothing) {
  const CholeskyProblem problem = mesh_problem(60, 2);
  const int before_analysis = num_allocations();
  MultifrontalCholesky cholesky(problem.lower, problem.tree(), 2);
  EXPECT_GT(num_allocations(), before_analysis);
  const int before = num_allocations();
  const bool positive_definite = cholesky.factorize(problem.lower) && cholesky.factorize(problem.lower);
  EXPECT_EQ(num_allocations(), before);
  EXPECT_TRUE(positive_definite);
}

std::pair<int, int> placement_allocations(int n) {
  const SheetToFlatten flat(n);
  const WireNetwork network = build_wire_network(flat.chart);
  const InteriorPlacement placement(flat.chart, network);
  Positions2 uv = flat.uv;
  const int place = allocations_of([&] { placement.place(uv); });
  return {place, allocations_of([&] { placement.pull_back(uv); })};
}

TEST(Budgets, InteriorPlacementAllocatesEquallyOftenOnEveryMesh) {
  EXPECT_EQ(placement_allocations(8), placement_allocations(24));
}

std::pair<int, int> newton_allocations(int n) {
  const SheetToFlatten flat(n);
  const HeldNetwork network = build_held_network(flat.chart);
  const LengthConstraints constraints(flat.chart, network);
  FairShapeError objective(flat.chart, network, 0.1);
  NewtonSystem system(flat.chart, objective, constraints, flat.uv);
  const Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(constraints.size());
  const auto factorize = [&] { system.factorize(flat.uv, multipliers, {Curvature::convex, false}); };
  factorize();
  const Eigen::VectorXd residual = Eigen::VectorXd::Zero(constraints.size());
  return {allocations_of(factorize),
          allocations_of([&] { system.finish(system.solve_on_wires(flat.uv, residual).d); })};
}

TEST(Budgets, NewtonSystemsAllocateEquallyOftenOnEveryMesh) {
  EXPECT_EQ(newton_allocations(8), newton_allocations(24));
}

struct RefinementCost {
  int factorizations;
  double substitutions;  // forward and back through all fronts, with up to four right-hand sides
};

RefinementCost cost_of_refinement(const FlattenInput& input) {
  const Chart chart = test::chart_of(input);
  const Positions2 start = free_boundary_arap(chart, 30).uv;
  const FrontCounts before = count_fronts();
  Budget budget(100);
  const Solution found = minimize({chart, 0.1}, {}, {start}, {budget});
  const FrontCounts after = count_fronts();
  EXPECT_TRUE(found.is_converged());
  const auto fronts = static_cast<double>(after.factored - before.factored) / found.factorizations;
  const auto visited = static_cast<double>(after.substituted_forward - before.substituted_forward +
                                           after.substituted_back - before.substituted_back);
  return {found.factorizations, visited / (2 * fronts)};
}

TEST(Budgets, ARefinementSubstitutesAFewTimesPerFactorization) {
  const RefinementCost coarse = cost_of_refinement(sheet(8)), fine = cost_of_refinement(sheet(48));
  for (const RefinementCost& cost : {coarse, fine}) {
    EXPECT_LE(cost.factorizations, 4);
    EXPECT_LE(cost.substitutions, 15 * cost.factorizations);
  }
  EXPECT_LT(fine.substitutions, 0.75 * coarse.substitutions) << "most substitutions visit only the branches with wires";
}

struct WorkBetweenQuestions {
  void answer() {
    const FrontCounts now = count_fronts();
    factored = std::max(factored, now.factored - last.factored);
    substituted = std::max(substituted, now.substituted_forward - last.substituted_forward);
    last = now;
  }
  FrontCounts last = count_fronts();
  long factored = 0, substituted = 0;
};

long fronts_of(const FlattenInput& input) {
  const Chart chart = test::chart_of(input);
  const Positions2 start = free_boundary_arap(chart, kFreeSteps).uv;
  const long before = count_fronts().factored;
  Budget one(1);
  minimize({chart, 0.1}, {}, {start}, {one});
  return count_fronts().factored - before;
}

TEST(Cancelling, EndsARunAtOnceInEveryStage) {
  for (const double tolerance : {0.0, 1e-4}) {
    const FlattenInput input = test::saddle_of_wires(3, tolerance);
    const long fronts = fronts_of(input);
    // The search for tolerances makes all wires elastic, which takes two substitutions for each wire.
    const auto num_wires = static_cast<long>(input.wires.size());
    for (const Method method : {Method::refined, Method::wirewarp_plus_plus}) {
      Options options = test::by(method);
      WorkBetweenQuestions whole;
      int questions = 0;
      const FlattenResult refused = flatten(input, options, [&](const std::string& stage, double) {
        whole.answer();
        questions += stage != "measure";
        return true;
      });
      test::expect_error(refused.pieces.at(0).error, ErrorCode::infeasible_lengths);
      EXPECT_LE(whole.factored, 3 * fronts) << "for the embedding in a circle, and for the free shape";
      EXPECT_LE(whole.substituted, (35 + 2 * num_wires) * fronts)
          << "for steps to exact lengths, and two for each wire";
      for (int last = 0; last < questions; last += 1 + questions / 20) {
        int asked = 0;
        WorkBetweenQuestions after;
        const FlattenResult result = flatten(input, options, [&](const std::string&, double) {
          after = {};
          return asked++ < last;
        });
        after.answer();
        EXPECT_EQ(asked, last + 1);
        test::expect_error(result.pieces.at(0).error, ErrorCode::cancelled);
        EXPECT_EQ(after.factored, 0) << last;
        EXPECT_EQ(after.substituted, 0) << last;
      }
    }
  }
}

}  // namespace
}  // namespace wirewarp::test_budgets
