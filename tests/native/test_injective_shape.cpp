// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of pieces for which the usual starts lead to flipped or overlapping shapes, although a good shape exists.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "base/planar.h"
#include "newton/injective_shape.h"
#include "newton/refine_chart.h"
#include "test_meshes.h"

namespace wirewarp::test_injective_shape {
namespace {

/// Returns the finger of a glove, a bump on a square. The bump is as high as the square is wide. A row and a column are
/// wires.
FlattenInput finger(double tolerance = 0) {
  const int n = 8;
  FlattenInput input = test::height_field(n, [](double x, double y) { return 2 * std::exp(-4 * (x * x + y * y)); });
  test::add_wire(input, test::grid_row(n, n / 2), tolerance);
  test::add_wire(input, test::grid_column(n, n, n / 2), tolerance);
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

Solution refine(const FlattenInput& input) { return refine_chart(test::charts_of(input).charts.at(0), Options{}); }

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
  const Charts charts = test::charts_of(finger());
  Problem problem(charts.charts.at(0), Options{}.fairness);
  const auto spent_of = [&](int most) {
    Budget budget(most);
    refine_chart(problem, Options{}, {budget});
    return budget.spent();
  };
  const int whole = spent_of(Options{}.max_factorizations);
  for (const int most : {whole / 4, whole / 2, whole - 1, whole}) EXPECT_EQ(spent_of(most), most);
}

}  // namespace
}  // namespace wirewarp::test_injective_shape
