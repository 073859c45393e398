// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the starts of the refined method on one chart, of charts that unfold, and of shapes that would flip or
// overlap themselves.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <string>

#include "base/internal_options.h"
#include "base/planar.h"
#include "energy/free_boundary_arap.h"
#include "energy/shape_error.h"
#include "newton/injective_shape.h"
#include "newton/minimize.h"
#include "newton/refine_chart.h"
#include "newton/starts.h"
#include "newton/unfold.h"
#include "surface/mesh/geometry.h"
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
  const Chart chart = test::chart_of(test::quarter_sphere(8));
  InternalOptions options;
  for (const bool makes_injective : {true, false}) {
    options.makes_injective = makes_injective;
    EXPECT_EQ(injectivity_of(chart, refine_chart(chart, options).shape.uv), Injectivity::global) << makes_injective;
  }
}

TEST(RefineChart, AStoredFreeMapChangesNoShape) {
  Chart chart = test::chart_of(test::saddle(8, 0.3));
  const Solution without = refine_chart(chart, Options{});
  ASSERT_STREQ(without.start, "free");
  chart.free_map = free_boundary_arap(chart, kFreeSteps).uv;
  EXPECT_EQ(refine_chart(chart, Options{}).shape.uv, without.shape.uv);
  *chart.free_map *= 1.25;
  EXPECT_EQ(Problem(chart, Options{}.fairness).free_map(StopToken()), *chart.free_map);
}

/// If an intermediate shape becomes the result, the report of its piece says that the search ended before it reached
/// the least distortion.
TEST(RefineChart, AnIntermediateShapeIsConvergedOnlyWithoutStrain) {
  InternalOptions options;
  for (const Target target : {Target::newton_step, Target::rough}) {
    options.target = target;
    const Solution saddle = refine_chart(test::chart_of(test::saddle(8, 0.3)), options);
    EXPECT_TRUE(saddle.is_exact() && !saddle.is_converged());
    const Solution sheet = refine_chart(test::chart_of(test::flat_rectangle(2, 2, 1, 1)), options);
    EXPECT_TRUE(sheet.is_exact() && sheet.is_converged());
  }
}

/// On a strongly curved net, one step from the free shape does not reach exact lengths, so the solver starts from the
/// wires.
TEST(RefineChart, ANetFarFromTheFreeShapeStartsFromItsWires) {
  const int n = 12;
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double longitude = 2 * (s - 0.5), latitude = 2 * (t - 0.5);
    return Eigen::Vector3d(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                           std::cos(longitude) * std::cos(latitude));
  });
  test::add_net(input, n, {2, 4, 6, 8, 10});
  const Solution refined = refine_chart(test::chart_of(input), Options{});
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

/// Surface and wires are symmetric under half a turn, and the objective f has a saddle at the least distorted symmetric
/// shape. Gradients are symmetric too, so they cannot lead away from the saddle.
TEST(RefineChart, LeavesASaddleUnderANetOfWires) {
  const int n = 12;
  FlattenInput input = test::saddle(n, 0.9);
  test::add_net(input, n, {3, 6, 9});
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

TEST(RefineChart, StartsFromACoarseChartFromTheGivenSizeOn) {
  const int n = 32;  // 2,048 faces
  FlattenInput input = test::make_grid(
      n, n, [](double s, double t) { return Eigen::Vector3d(s, t, 0.3 * std::sin(kPi * s) * std::sin(kPi * t)); });
  test::add_wire(input, test::grid_row(n, n / 2));
  const Chart chart = test::chart_of(input);
  InternalOptions options;
  options.fairness = 0.3;
  const auto refined = [&](std::size_t large_chart, Budget& budget) {
    options.large_chart = large_chart;
    Problem problem(chart, options.fairness);
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
  test::add_net(input, n, {8, 16, 24, 32, 40});
  test::add_wire(input, test::section(test::grid_row(n, 4), 20, 28));
  InternalOptions options;
  options.large_chart = static_cast<std::size_t>(input.faces.rows());
  Budget budget(5);
  const Chart chart = test::chart_of(input);
  Problem problem(chart, options.fairness);
  const Solution refined = refine_chart(problem, options, {budget});
  EXPECT_TRUE(refined.is_exact() && budget.ran_out()) << "exact lengths, but not more after five steps";
  EXPECT_STREQ(refined.start, "wires");
}

/// Returns the energy of the unfolded chart over its area, or infinity if the chart does not unfold.
double strain_energy(const FlattenInput& input) {
  const Chart chart = test::chart_of(input);
  const auto flat = unfold(chart);
  if (!flat) return std::numeric_limits<double>::infinity();
  return ShapeError(chart).energy(flat->uv) / surface_area(chart.mesh);
}

TEST(Unfold, FoldedSheetsKeepAllTriangles) {
  FlattenInput slit_tube = test::cylinder_tube(24, 6, 1, 2);
  test::add_seam(slit_tube, test::tube_line(24, 6, 0));
  for (const FlattenInput& input :
       {test::flat_annulus(16, 3, 1, 3), test::flat_plate_with_two_holes(4), test::cylinder_patch(20, 8, 1, 5, 3),
        test::cone_patch(20, 8, 0.1, 3, 0.4, 6), slit_tube, test::flat_rectangle(200, 200, 1, 1)}) {
    EXPECT_LE(strain_energy(input), 1e-22);  // strains of 1e-11
  }
}

TEST(Unfold, ShortEdgesDoNotTurnTheFacesBehindThem) {
  const double shortest = 1e-9;  // across these edges, directions have errors of 1e-7
  const FlattenInput input = test::make_grid(30, 30, [&](double s, double t) -> Eigen::Vector3d {
    const double x = std::pow(shortest, 1 - s), y = std::pow(shortest, 1 - t);
    return {std::sin(x), std::cos(x), y};
  });
  EXPECT_LE(strain_energy(input), 1e-22);
}

TEST(Unfold, CurvedAndClosedSurfacesDoNotUnfold) {
  for (const FlattenInput& input : {test::saddle(8, 0.1), test::quarter_sphere(8), test::cylinder_tube(12, 3, 1, 1)}) {
    EXPECT_TRUE(std::isinf(strain_energy(input)));
  }
}

TEST(Unfold, AnUnfoldedChartNeedsNoFactorization) {
  FlattenInput input = test::cylinder_patch(20, 8, 1, kPi, 3);
  test::add_wire(input, test::grid_row(20, 4));
  test::add_wire(input, test::grid_column(20, 8, 7), 0.05);
  const Solution found = refine_chart(test::chart_of(input), Options{});
  EXPECT_TRUE(found.is_exact() && found.is_converged());
  EXPECT_EQ(found.factorizations, 0);
  EXPECT_LE(found.objective, 1e-20);
}

/// The vertices are slightly off a plane, as in files with seven digits.
TEST(Unfold, ANearlyFlatChartIsRefinedFromItsUnfolding) {
  const double digits = 1e-7;
  unsigned state = 1;
  const FlattenInput input = test::make_grid(20, 20, [&](double s, double t) -> Eigen::Vector3d {
    state = state * 1664525u + 1013904223u;
    return {s, t, digits * (state >> 16) / 65536.0};
  });
  const double unfolded = strain_energy(input);
  const Piece piece = flatten(input).pieces.at(0);
  EXPECT_FALSE(piece.error);
  EXPECT_EQ(piece.report.termination, Termination::converged);
  EXPECT_LE(piece.metrics.arap_energy, unfolded);
}

/// Returns the finger of a glove, which is a bump on a square, as high as the square is wide. Two wires cross on it.
FlattenInput finger(double tolerance = 0) {
  FlattenInput input = test::height_field(8, [](double x, double y) { return 2 * std::exp(-4 * (x * x + y * y)); });
  test::add_net(input, 8, {4}, tolerance);
  return input;
}

/// Returns a saddle with a vent. The sides of the vent would overlap in the plane.
FlattenInput saddle_with_vent() {
  return test::keep_faces(test::saddle(24, 0.5),
                          [](const Eigen::Vector3d& p) { return !(std::abs(p.x()) < 0.1 && p.y() > -0.5); });
}

/// Returns a strip that runs around a saddle twice. In the plane, the strip turns by a larger angle than on the
/// surface, so the second round would meet the first.
FlattenInput spiral_on_a_saddle() {
  return test::make_grid(96, 2, [](double s, double t) {
    const double turn = 4 * kPi * s, radius = 0.6 + 0.3 * s - (t - 0.5) * 0.1;
    const double x = radius * std::cos(turn), y = radius * std::sin(turn);
    return Eigen::Vector3d(x, y, 0.5 * (x * x - y * y));
  });
}

Solution refine(const FlattenInput& input) { return refine_chart(test::chart_of(input), Options{}); }

TEST(InjectiveShape, NothingFlipsOrOverlapsIfAnInjectiveShapeExists) {
  for (const FlattenInput& input : {finger(), saddle_with_vent(), spiral_on_a_saddle()}) {
    const Chart chart = test::chart_of(input);
    const Solution found = refine(input);
    ASSERT_TRUE(found.is_exact());
    EXPECT_LT(found.length_error, 1e-10);
    EXPECT_EQ(injectivity_of(chart, found.shape.uv), Injectivity::global);
    EXPECT_FALSE(flatten(input).pieces.at(0).error);
  }
}

TEST(InjectiveShape, InjectiveShapesDoNotChange) {
  const Chart chart = test::chart_of(test::quarter_sphere(12));
  const Solution found = refine(test::quarter_sphere(12));
  Budget budget(100);
  Solution same = found;
  Problem problem(chart, Options{}.fairness);
  make_injective(problem, {}, {budget}, same);
  EXPECT_STREQ(same.start, found.start);
  EXPECT_EQ(same.shape.uv, found.shape.uv);
  EXPECT_EQ(budget.spent(), 0);
}

TEST(InjectiveShape, TheScaleOfTheModelDoesNotMatter) {
  for (const FlattenInput& input : {finger(), saddle_with_vent(), spiral_on_a_saddle()}) {
    const Solution expected = refine(input);
    for (const double scale : {1.0 / 1024, 1024.0}) {  // powers of 4, which do not change the rounding of square roots
      FlattenInput scaled = input;
      scaled.vertices *= scale;
      const Solution found = refine(scaled);
      ASSERT_TRUE(found.is_exact()) << scale;
      EXPECT_EQ(found.injectivity, expected.injectivity) << scale;
      EXPECT_NEAR(found.objective, expected.objective, 1e-9 * expected.objective) << scale;
    }
  }
}

TEST(InjectiveShape, MoreToleranceIsNeverWorse) {
  double before = refine(finger()).objective;
  for (const double tolerance : {0.01, 0.03, 0.1}) {
    const double looser = refine(finger(tolerance)).objective;
    EXPECT_FALSE(flatten(finger(tolerance)).pieces.at(0).error) << tolerance;
    EXPECT_LE(looser, before * (1 + 1e-9)) << tolerance;
    before = looser;
  }
}

TEST(InjectiveShape, FactorizationsAreCounted) {
  const Chart chart = test::chart_of(finger());
  Problem problem(chart, Options{}.fairness);
  const auto spent_of = [&](int most) {
    Budget budget(most);
    refine_chart(problem, Options{}, {budget});
    return budget.spent();
  };
  const int whole = spent_of(Options{}.max_factorizations);
  for (const int most : {whole / 4, whole / 2, whole - 1, whole}) EXPECT_EQ(spent_of(most), most);
}

}  // namespace
}  // namespace wirewarp::test_refine_chart
