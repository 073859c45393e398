// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the starts of the refined method on one chart. Their work is counted, limited and reported as progress.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/internal_options.h"
#include "base/planar.h"
#include "energy/free_boundary_arap.h"
#include "newton/injective_shape.h"
#include "newton/minimize.h"
#include "newton/refine_chart.h"
#include "newton/starts.h"
#include "test_meshes.h"

namespace wirewarp::test_refine_chart {
namespace {

TEST(RefineChart, CountsStartsThatFail) {
  const Chart chart = test::chart_of(test::saddle_of_wires(4, 1e-4));
  Problem problem(chart, Options{}.fairness);
  Budget unlimited(1000);
  const Solution whole = refine_chart(problem, Options{}, {unlimited});
  ASSERT_FALSE(whole.is_exact());
  EXPECT_FALSE(unlimited.ran_out());
  EXPECT_STREQ(whole.start, "");
  for (const int most : {1, 2, 3, 10, unlimited.spent() - 1}) {
    Budget budget(most);
    refine_chart(problem, Options{}, {budget});
    EXPECT_EQ(budget.spent(), most);
    EXPECT_TRUE(budget.ran_out());
  }
}

TEST(RefineChart, AnInjectiveShapeIsFoundWithAndWithoutFixingFolds) {
  const Charts charts = test::charts_of(test::quarter_sphere(8));
  InternalOptions options;
  for (const bool makes_injective : {true, false}) {
    options.makes_injective = makes_injective;
    const Solution found = refine_chart(charts.charts.at(0), options);
    EXPECT_EQ(injectivity_of(charts.charts.at(0), found.shape.uv), Injectivity::global) << makes_injective;
  }
}

/// If an intermediate shape becomes the result, the report of its piece says that the search ended before it reached
/// the least distortion.
TEST(RefineChart, AnIntermediateShapeIsConvergedOnlyWithoutStrain) {
  InternalOptions options;
  for (const Target target : {Target::newton_step, Target::rough}) {
    options.target = target;
    const Solution saddle = refine_chart(test::charts_of(test::saddle(8, 0.3)).charts.at(0), options);
    EXPECT_TRUE(saddle.is_exact() && !saddle.is_converged());
    const Solution sheet = refine_chart(test::charts_of(test::flat_rectangle(2, 2, 1, 1)).charts.at(0), options);
    EXPECT_TRUE(sheet.is_exact() && sheet.is_converged());
  }
}

/// On a strongly curved net, one step from the free shape does not reach exact lengths.
TEST(RefineChart, ANetFarFromTheFreeShapeStartsFromItsWires) {
  const int n = 12;
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double longitude = 2 * (s - 0.5), latitude = 2 * (t - 0.5);
    return Eigen::Vector3d(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                           std::cos(longitude) * std::cos(latitude));
  });
  for (const int i : {2, 4, 6, 8, 10}) {
    test::add_wire(input, test::grid_row(n, i));
    test::add_wire(input, test::grid_column(n, n, i));
  }
  const Solution refined = refine_chart(test::charts_of(input).charts.at(0), Options{});
  EXPECT_TRUE(refined.is_exact() && refined.is_converged());
  EXPECT_STREQ(refined.start, "wires");
}

TEST(RefineChart, ContradictingLengthsHaveTheSameErrorAtEveryLimit) {
  const FlattenInput input = test::saddle_of_wires(4, 0);
  const auto error_with = [&](int max_factorizations) {
    Options options;
    options.max_factorizations = max_factorizations;
    return *flatten(input, options).pieces.at(0).error;
  };
  const FlattenError whole = error_with(1000), brief = error_with(1);
  EXPECT_STREQ(brief.what(), whole.what());  // because a higher limit would not help
  const auto &expected = whole.elements.proposed_tolerances, &proposed = brief.elements.proposed_tolerances;
  ASSERT_FALSE(expected.empty());
  ASSERT_EQ(proposed.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(proposed[i].wire, expected[i].wire);
    EXPECT_EQ(proposed[i].tolerance, expected[i].tolerance);
  }
}

TEST(RefineChart, CheapStepsOfTheFreeStartAreLittleProgress) {
  int num_starts = 0;
  double before_shape = 0;
  bool has_begun_shape = false;
  const FlattenResult result = flatten(test::quarter_sphere(12), {}, [&](const std::string& stage, double fraction) {
    has_begun_shape = has_begun_shape || stage == "shape";
    if (stage != "start" || has_begun_shape) return true;
    ++num_starts;
    before_shape = fraction;
    return true;
  });
  EXPECT_FALSE(result.pieces.at(0).error);
  EXPECT_GT(num_starts, 5);
  EXPECT_GT(before_shape, 0.2);
  EXPECT_LT(before_shape, 0.3);
}

/// Surface and wires are symmetric under half a turn, and f has a saddle at the least distorted symmetric shape.
/// Gradients are symmetric too, so they cannot lead away from the saddle.
TEST(RefineChart, LeavesASaddleUnderANetOfWires) {
  const int n = 12;
  FlattenInput input = test::saddle(n, 0.9);
  for (const int i : {3, 6, 9}) {
    test::add_wire(input, test::grid_row(n, i));
    test::add_wire(input, test::grid_column(n, n, i));
  }
  const Chart chart = test::chart_of(input);
  Problem problem(chart, Options{}.fairness);
  Budget budget(100);
  std::optional<Shape> start = flatten_wires_first(problem, {budget});
  ASSERT_TRUE(start);
  Solution saddle;
  for (int i = 0; i < 5; ++i) {
    Budget one_step(2);  // one rejected Newton step, and one step in the trust region
    saddle = minimize(problem, {}, *start, {one_step});
    EXPECT_TRUE(saddle.is_exact());
    const Positions2 turned = -saddle.shape.uv.colwise().reverse();
    // Removes the asymmetric part, which rounding errors cause.
    *start = {(saddle.shape.uv + turned) / 2, {}, saddle.shape.multipliers};
  }
  const Solution found = minimize(problem, {}, *start, {budget});
  EXPECT_TRUE(found.is_exact() && found.is_converged());
  EXPECT_LT(found.objective, 0.96 * saddle.objective);
}

/// A large chart starts from a coarser chart, and reaches the minimum that is found without the coarser chart.
TEST(RefineChart, StartsFromACoarseChartFromTheGivenSizeOn) {
  const int n = 32;  // 2,048 faces
  FlattenInput input = test::make_grid(
      n, n, [](double s, double t) { return Eigen::Vector3d(s, t, 0.3 * std::sin(kPi * s) * std::sin(kPi * t)); });
  test::add_wire(input, test::grid_row(n, n / 2));
  const Charts charts = test::charts_of(input);
  InternalOptions options;
  options.fairness = 0.3;
  const auto refined = [&](std::size_t large_chart, Budget& budget) {
    options.large_chart = large_chart;
    Problem problem(charts.charts.at(0), options.fairness);
    return refine_chart(problem, options, {budget});
  };
  Budget budget(options.max_factorizations), coarse_budget(options.max_factorizations);
  const Solution from_scratch = refined(2049, budget), from_coarse = refined(2048, coarse_budget);
  EXPECT_STREQ(from_scratch.start, "free");
  EXPECT_STREQ(from_coarse.start, "coarse");
  EXPECT_GT(coarse_budget.spent(), from_coarse.factorizations) << "factorizations of the coarse chart count too";
  EXPECT_NEAR(from_coarse.objective, from_scratch.objective, 1e-9 * from_scratch.objective);
}

/// On the coarse chart, the wires contradict one another, and one wire ends inside. So the solver tries all starts of
/// the coarse chart, including topology processing.
TEST(RefineChart, IfTheCoarseChartFailsTheFineChartIsSolvedAlone) {
  const int n = 48;
  FlattenInput input = test::make_grid(
      n, n, [](double s, double t) { return Eigen::Vector3d(s, t, 1.2 * std::sin(kPi * s) * std::sin(kPi * t)); });
  for (int i = 8; i < n; i += 8) {
    test::add_wire(input, test::grid_row(n, i));
    test::add_wire(input, test::grid_column(n, n, i));
  }
  const std::vector<int> row = test::grid_row(n, 4);
  test::add_wire(input, {row.begin() + 20, row.begin() + 29});
  InternalOptions options;
  options.large_chart = static_cast<std::size_t>(input.faces.rows());
  Budget budget(5);
  const Charts charts = test::charts_of(input);
  Problem problem(charts.charts.at(0), options.fairness);
  const Solution refined = refine_chart(problem, options, {budget});
  EXPECT_TRUE(refined.is_exact() && budget.ran_out()) << "exact lengths, but not more after five steps";
  EXPECT_STREQ(refined.start, "wires");
}

}  // namespace
}  // namespace wirewarp::test_refine_chart
