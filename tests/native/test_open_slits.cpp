// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of charts with slits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "newton/refine_chart.h"
#include "surface/charts/slits.h"
#include "test_meshes.h"

namespace wirewarp::test_open_slits {
namespace {

constexpr int kSize = 20;

int vertex(int i, int j) { return i + (kSize + 1) * j; }

std::vector<int> along_row(int i, int j, int num_edges) {
  return test::section(test::grid_row(kSize, j), i, i + num_edges);
}

/// Returns a bump with two slits: at the top, where the sheet is compressed, and on the slope, where the sheet is
/// stretched sideways.
FlattenInput bump_with_slits() {
  FlattenInput input = test::make_grid(kSize, kSize, [](double s, double t) {
    return Eigen::Vector3d(s, t, 0.25 * std::exp(-12 * ((s - 0.5) * (s - 0.5) + (t - 0.4) * (t - 0.4))));
  });
  test::add_seam(input, along_row(8, 8, 5));
  test::add_seam(input, test::section(test::grid_column(kSize, kSize, 10), 14, 19));
  return input;
}

/// Returns the largest distance between the two copies of a vertex on the rims of the slit.
double gap(const Chart& chart, const Slit& slit, const Positions2& uv) {
  double largest = 0;
  for (std::size_t i = 0; i < slit.rims.size(); ++i) {
    const int one = chart.mesh.from_vertex_handle(slit.rims[i]).idx();
    const int other = chart.mesh.to_vertex_handle(slit.rims[slit.mate[i]]).idx();
    largest = std::max(largest, (uv.row(one) - uv.row(other)).norm());
  }
  return largest;
}

TEST(OpenSlits, OneSlitOpensAndOneStaysShut) {
  const FlattenInput input = bump_with_slits();
  const Chart chart = test::chart_of(input);
  Problem problem(chart, Options{}.fairness);
  Budget budget(15);
  const Solution found = refine_chart(problem, Options{}, {budget});
  EXPECT_TRUE(found.is_exact() && found.is_converged());
  std::vector<double> gaps;
  for (const Slit& slit : find_slits(chart)) gaps.push_back(gap(chart, slit, found.shape.uv));
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(std::min(gaps[0], gaps[1]), 0);
  EXPECT_GT(std::max(gaps[0], gaps[1]), 1e-4);
  const Piece piece = flatten(input).pieces.at(0);
  EXPECT_FALSE(piece.error) << piece.error->what();
  EXPECT_EQ(piece.report.objective, found.objective);
}

TEST(OpenSlits, StopAtAnyBudgetWithExactLengths) {
  const Chart chart = test::chart_of(bump_with_slits());
  Problem problem(chart, Options{}.fairness);
  Budget unlimited(100);
  const Solution whole = refine_chart(problem, Options{}, {unlimited});
  for (int most = 1; most < unlimited.spent(); ++most) {
    Budget budget(most);
    const Solution found = refine_chart(problem, Options{}, {budget});
    EXPECT_TRUE(found.is_exact()) << most;
    EXPECT_FALSE(found.is_converged()) << most;
    EXPECT_EQ(budget.spent(), most);
    EXPECT_GE(found.objective, whole.objective * (1 - 1e-9)) << most;
  }
}

FlattenInput waves(int n, double bend_s, double bend_t, double wave) {
  return test::make_grid(n, n, [&](double s, double t) {
    const double bend = bend_s * s * (1 - s) + bend_t * t * (1 - t);
    return Eigen::Vector3d(s, t, bend + wave * std::sin(5 * s) * std::cos(4 * t));
  });
}

TEST(OpenSlits, TheSewnChartTriesLaterStartsToo) {
  FlattenInput input = waves(22, -0.242964, 0.410214, -0.297067);
  test::add_seam(input, {146, 169, 192, 193, 194, 195});
  test::add_wire(input, test::grid_row(22, 20));
  Options options;
  options.fairness = 0.03;
  const Piece piece = flatten(input, options).pieces.at(0);
  EXPECT_FALSE(piece.error) << piece.error->what();
  EXPECT_EQ(piece.report.termination, Termination::converged);
}

TEST(OpenSlits, AShapeThatWouldPassThroughAShutSlitIsRejected) {
  FlattenInput input = waves(12, 0.081492, 0.09485, -0.079414);
  test::add_seam(input, {136, 135, 122, 109, 96, 83, 70, 69, 68, 81, 80});
  test::add_seam(input, {82, 95, 108});
  test::add_wire(input, test::grid_row(12, 8));
  test::add_wire(input, test::grid_column(12, 12, 5));
  const Piece piece = flatten(input).pieces.at(0);
  EXPECT_FALSE(piece.error) << piece.error->what();
  EXPECT_EQ(piece.report.termination, Termination::converged);
  EXPECT_LE(piece.report.factorizations, 50);
}

TEST(OpenSlits, RimsOfAPieceThatUnfoldsUpToRoundingStayApart) {
  const std::vector<std::vector<int>> slits = {along_row(5, 4, 8),
                                               {vertex(10, 2), vertex(10, 3), vertex(10, 4)},
                                               {vertex(4, 2), vertex(5, 3), vertex(6, 4), vertex(7, 5), vertex(8, 6)},
                                               {vertex(4, 2), vertex(4, 3), vertex(5, 3), vertex(6, 3), vertex(6, 4)},
                                               along_row(9, 3, 1),
                                               along_row(3, 1, 14)};
  for (std::size_t s = 0; s < slits.size(); ++s) {
    FlattenInput input = test::cylinder_patch(20, 8, 1, 2, 1);
    input.vertices = input.vertices.cast<float>().cast<double>();  // as Blender stores positions
    test::add_seam(input, slits[s]);
    const Piece piece = flatten(input).pieces.at(0);
    EXPECT_FALSE(piece.error) << s << ": " << piece.error->what();
    EXPECT_EQ(piece.report.termination, Termination::converged) << s;
    EXPECT_LE(piece.metrics.arap_energy, 1e-12) << s << ": strains of 1e-6";
  }
}

TEST(OpenSlits, OpenEquallyFarOnFineAndCoarseMeshes) {
  std::vector<double> gaps, objectives;
  for (const int n : {12, 36, 108}) {  // slits of 6, 18 and 54 edges
    FlattenInput input = test::make_grid(n, n, [](double s, double t) {
      return Eigen::Vector3d(s, t, 0.25 * std::exp(-12 * ((s - 0.5) * (s - 0.5) + (t - 0.2) * (t - 0.2))));
    });
    test::add_seam(input, test::section(test::grid_column(n, n, n / 2), n / 2 - n / 12, n - n / 12));
    const Chart chart = test::chart_of(input);
    Problem problem(chart, Options{}.fairness);
    Budget budget(8);  // enough factorizations only if no face flips
    const Solution found = refine_chart(problem, Options{}, {budget});
    EXPECT_TRUE(found.is_exact() && found.is_converged()) << n;
    gaps.push_back(gap(chart, find_slits(chart).at(0), found.shape.uv));
    objectives.push_back(found.objective);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(gaps[i], gaps[2], 0.1 * gaps[2]) << i;
    EXPECT_NEAR(objectives[i], objectives[2], 0.02 * objectives[2]) << i;
  }
}

}  // namespace
}  // namespace wirewarp::test_open_slits
