// SPDX-License-Identifier: GPL-3.0-or-later
// Slits of two and three edges on a dome stopped after 100 factorizations at 1.7 to 2.7 times the objective, or with
// rims that cross each other: at a closed slit, the branches of exact shapes cross.
#include <gtest/gtest.h>

#include <string>

#include "energy/fair_shape_error.h"
#include "newton/refine_chart.h"
#include "surface/charts/slits.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"

namespace wirewarp::closed_slits_stopped_short_test {
namespace {

/// Steps (i, j) on the grid from the middle.
enum class Way { along_row, along_column, diagonal, corner };

std::vector<int> slit(int n, Way way, int num_edges) {
  int i = n / 2 - num_edges / 2, j = n / 2;
  std::vector<int> chain{i + (n + 1) * j};
  for (int step = 0; step < num_edges; ++step) {
    const bool turned = way == Way::corner && step >= (num_edges + 1) / 2;
    i += way == Way::along_column || turned ? 0 : 1;
    j += way == Way::along_column || way == Way::diagonal || turned ? 1 : 0;
    chain.push_back(i + (n + 1) * j);
  }
  return chain;
}

FlattenInput dome(int n, double height) {
  return test::make_grid(
      n, n, [&](double s, double t) { return Eigen::Vector3d(s, t, height * (s * (1 - s) + t * (1 - t))); });
}

/// Returns f over the area of the best shape with all slits closed.
double shut_objective(const FlattenInput& input, const Options& options) {
  const Charts charts = test::charts_of(input);
  const Chart& chart = charts.charts.at(0);
  const SewnChart sewn = *sew(chart, find_slits(chart));
  const Solution shut = refine_chart(sewn.chart, options);
  EXPECT_TRUE(shut.is_exact() && shut.is_converged());
  const FairShapeError objective(chart, build_held_network(chart), options.fairness);
  return objective.value(shut.shape.uv(sewn.vertex, Eigen::all)) / surface_area(chart.mesh);
}

TEST(Bugs, ClosedSlitsOfAFewEdgesTakeHardlyLongerThanWires) {
  for (const int n : {12, 20}) {
    for (const double fairness : {0.1, 0.3}) {
      for (const Way way : {Way::along_row, Way::along_column, Way::diagonal, Way::corner}) {
        for (int num_edges = 1; num_edges <= 6; ++num_edges) {
          SCOPED_TRACE(std::to_string(n) + " x " + std::to_string(n) + ", " + std::to_string(num_edges) +
                       " edges, way " + std::to_string(static_cast<int>(way)) + ", fairness " +
                       std::to_string(fairness));
          FlattenInput input = dome(n, 0.3);
          test::add_seam(input, slit(n, way, num_edges));
          Options options;
          options.fairness = fairness;
          const Piece piece = flatten(input, options).pieces.at(0);
          EXPECT_FALSE(piece.error) << piece.error->what();
          EXPECT_EQ(piece.report.termination, Termination::converged);
          EXPECT_LE(piece.report.factorizations, 20);
          EXPECT_LE(piece.report.objective, shut_objective(input, options) * (1 + 1e-9));
        }
      }
    }
  }
}

}  // namespace
}  // namespace wirewarp::closed_slits_stopped_short_test
