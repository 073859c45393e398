// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that charts that were folded from a plane unfold without strain, and that other charts do not unfold.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/planar.h"
#include "energy/shape_error.h"
#include "newton/refine_chart.h"
#include "newton/unfold.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"

namespace wirewarp::test_unfold {
namespace {

/// Returns the energy of the unfolded chart per area, or infinity if the chart does not unfold.
double strain_energy(const FlattenInput& input) {
  const Charts charts = test::charts_of(input);
  const auto flat = unfold(charts.charts.at(0));
  if (!flat) return std::numeric_limits<double>::infinity();
  return ShapeError(charts.charts[0]).energy(flat->uv) / surface_area(charts.charts[0].mesh);
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

/// The vertices are slightly off a plane, as in files with seven digits. The solver starts from the unfolded chart,
/// and lowers its energy.
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

}  // namespace
}  // namespace wirewarp::test_unfold
