// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of elastic seams. All sides of an elastic seam get one length, which the run determines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/planar.h"
#include "disguise.h"
#include "eased_sheets.h"
#include "error_of.h"
#include "surface/charts/elastic_seams.h"
#include "surface/network/length_variation.h"
#include "test_meshes.h"
#include "wirewarp/cache.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test_elastic_seams {
namespace {

using test::ease_along;
using test::expect_good;
using test::seam_of_sheets;
using test::sheet_and_saddle;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double objective_of(const FlattenResult& result) {
  double sum = 0, area = 0;
  for (const Piece& piece : result.pieces) {
    sum += piece.report.objective * piece.metrics.area_3d;
    area += piece.metrics.area_3d;
  }
  return sum / area;
}

FlattenInput gores(double tolerance, double ease = 0) {
  FlattenInput input = test::sphere_of_gores(6, 3, 12, tolerance);
  for (Wire& wire : input.wires) wire.ease = ease;
  return input;
}

TEST(ElasticSeams, AreFixedDuringAStageAndElasticAfterIt) {
  FlattenInput input = test::flat_rectangle(4, 2, 2, 1);
  test::add_wire(input, test::grid_row(4, 0), 0.03);
  input.wires.back().ease = 0.1;
  Chart chart = test::chart_of(input);
  const Positions2 uv = test::planar_positions(chart);
  {
    const FixedSeams fixed(chart, {0.12});
    EXPECT_FALSE(is_elastic_boundary(chart.wire_parts[0]));
    EXPECT_NEAR(length_variation(chart, uv)[0], 1 / 1.12 - 1, 1e-12);
  }
  EXPECT_TRUE(is_elastic_boundary(chart.wire_parts[0]));
  EXPECT_NEAR(length_variation(chart, uv)[0], 1 / 1.1 - 1, 1e-12);
}

TEST(ElasticSeams, AreRefusedByWireWarpingPlusPlus) {
  FlattenInput input = sheet_and_saddle();
  test::add_wire(input, seam_of_sheets(), 0.03);
  Options options = test::by(Method::wirewarp_plus_plus);
  for (const Piece& piece : flatten(input, options).pieces) {
    EXPECT_EQ(test::expect_error(piece.error, ErrorCode::invalid_option).elements.edges.size(), 8u);
  }
}

TEST(ElasticSeams, AnElasticOutlineOfOnePieceLowersTheObjective) {
  const int n = 8;
  FlattenInput input = test::saddle(n, 0.3);
  const double rigid = objective_of(flatten(input));
  test::add_wire(input, test::grid_row(n, 0), 0.05);
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  EXPECT_LT(objective_of(result), rigid);
  EXPECT_NEAR(result.wires.at(0).length_2d, (1 + result.wires[0].variation) * result.wires[0].length_3d, 1e-8);
  EXPECT_GT(std::abs(result.wires[0].variation), 1e-3);
  EXPECT_LE(std::abs(result.wires[0].variation), 0.05 + 1e-12);
}

TEST(ElasticSeams, TheSidesOfADartHaveOneLength) {
  const int n = 8;
  FlattenInput input = test::saddle(n, 0.3);
  const std::vector<int> dart = test::section(test::grid_column(n, n, 3), 0, 3);
  test::add_seam(input, dart);
  test::add_wire(input, dart, 0.05);
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  const SeamReport& seam = result.seams.at(0);
  EXPECT_GT(std::abs(seam.variation), 1e-4);
  EXPECT_LT(seam.mismatch, 1e-9);
}

TEST(ElasticSeams, TheObjectiveNeverRisesWithTheTolerance) {
  Options of_cloth;
  of_cloth.cloth = cloth_preset("jersey").cloth;
  for (const Options& options : {Options(), of_cloth}) {
    double before = kInfinity;
    for (const double tolerance : {0.0, 0.01, 0.1, kInfinity}) {
      const FlattenInput input = gores(tolerance);
      const FlattenResult result = flatten(input, options);
      expect_good(input, result);
      const double objective = objective_of(result);
      EXPECT_LE(objective, before * (1 + 1e-9)) << tolerance;
      before = objective;
      for (const SeamReport& seam : result.seams) EXPECT_LE(std::abs(seam.variation), tolerance + 1e-12);
      if (tolerance == 0) continue;
      for (const Piece& piece : result.pieces) {
        EXPECT_LT(piece.report.projected_gradient, 1e-4);
        EXPECT_EQ(piece.report.termination, Termination::converged);
      }
    }
  }
}

/// Returns two triangles with sides of length 1, and a wire along the seam between them.
FlattenInput two_triangles(double tolerance, double ease) {
  const double height = std::sqrt(0.75);
  FlattenInput input =
      test::mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}, {0.5, -height, 0}}, {{0, 1, 2}, {1, 0, 3}});
  test::add_seam(input, {0, 1});
  test::add_wire(input, {0, 1}, tolerance);
  input.wires[0].ease = ease;
  return input;
}

TEST(ElasticSeams, StartWithinTheToleranceIfNominalLengthsAreInfeasible) {
  const FlattenInput input = two_triangles(0.5, 1.2);  // with a side of 2.2, two sides of 1 close no triangle
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  EXPECT_NEAR(result.seams.at(0).variation, 1.2 - 0.5, 1e-9) << "as short as allowed";
}

TEST(ElasticSeams, WithoutAFeasibleLengthAreAnError) {
  FlattenInput input = two_triangles(1.4, 1.5);
  // One piece has sides of 3 and 0.4, so its seam must be at least 2.6 long. The other piece has two sides of 1, so its
  // seam must be at most 2 long.
  input.eases = {ease_along({0, 3}, 2), ease_along({3, 1}, -0.6)};
  for (const Piece& piece : flatten(input).pieces) {
    test::expect_error(piece.error, ErrorCode::infeasible_lengths);
  }
}

/// Returns a flat ring with a small gap, and a wall on its rim. The top of the wall is shortened, so the wall is
/// distorted less if the seam is longer.
FlattenInput ring_with_wall(double tolerance) {
  const int around = 48, across = 3;
  FlattenInput input = test::make_grid(around, 2 * across, [](double s, double t) {
    const double angle = -(2 * kPi - 0.1) * s, radius = std::min(0.7 + 0.6 * t, 1.0), depth = std::max(t - 0.5, 0.0);
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), -0.6 * depth);
  });
  test::add_seam(input, test::grid_row(around, across));
  test::add_wire(input, test::grid_row(around, across), tolerance);
  std::vector<int> top = test::grid_row(around, 2 * across);
  std::reverse(top.begin(), top.end());
  input.eases.push_back(ease_along(top, -0.1));
  return input;
}

TEST(ElasticSeams, APieceThatWouldOverlapItselfIsSolvedAgainWithFixedLengths) {
  const FlattenInput input = ring_with_wall(0.05);
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  EXPECT_GT(result.seams.at(0).variation, 0.01) << "which closes the ring";
  EXPECT_TRUE(std::isnan(result.pieces.at(0).report.projected_gradient));
  EXPECT_LT(result.pieces.at(1).report.projected_gradient, 1e-4);
}

TEST(ElasticSeams, PiecesKeepNominalLengthsIfNoGoodShapeIsFound) {
  Options few;
  few.max_factorizations = 20;  // too few to find a ring that does not overlap itself
  const FlattenInput input = ring_with_wall(0.05);
  const FlattenResult result = flatten(input, few);
  expect_good(input, result);
  EXPECT_EQ(result.seams.at(0).variation, 0);
  int spent = 0, spent_at_ease = 0;
  for (const Piece& piece : result.pieces) {
    EXPECT_EQ(piece.report.termination, Termination::stalled);
    ASSERT_FALSE(piece.report.warnings.empty());
    test::expect_words(piece.report.warnings.back(), "keep their nominal lengths");
    spent += piece.report.factorizations;
  }
  for (const Piece& piece : flatten(ring_with_wall(0), few).pieces) spent_at_ease += piece.report.factorizations;
  EXPECT_GT(spent, spent_at_ease) << "the abandoned stages count too";
  const FlattenResult fixed = flatten(ring_with_wall(0));
  for (std::size_t p = 0; p < fixed.pieces.size(); ++p) {
    const double objective = fixed.pieces[p].report.objective;
    EXPECT_NEAR(result.pieces[p].report.objective, objective, 1e-6 * objective) << "the shape of the last good stage";
  }
}

/// One limit applies to all three stages: first seams are fixed, then they are elastic, then each piece is solved
/// alone.
TEST(ElasticSeams, NoPieceExceedsTheLimitOfFactorizations) {
  for (const int most : {1, 12, 25}) {
    Options options;
    options.max_factorizations = most;
    for (const Piece& piece : flatten(ring_with_wall(0.05), options).pieces) {
      EXPECT_LE(piece.report.factorizations, most);
    }
  }
}

/// A second attempt may spend only the rest of the limit, but its error must name the whole limit.
TEST(ElasticSeams, ErrorsNameTheLimitThatTheUserSet) {
  const int n = 4;
  FlattenInput input = test::saddle_of_wires(n, 0.2);
  test::add_seam(input, test::grid_column(n, n, n / 2));
  Options options;
  options.max_factorizations = 3;
  for (const Piece& piece : flatten(input, options).pieces) {
    ASSERT_TRUE(piece.error);
    test::expect_words(*piece.error, "max_factorizations = 3:");
  }
}

/// If the pieces were solved side by side in one plane, the last piece would have coordinates of about 100. Its edges
/// of length 1/40 would lose two digits.
TEST(ElasticSeams, AHundredCoupledPiecesAreAsExactAsOne) {
  const int num_pieces = 100, along = 40;
  FlattenInput input =
      test::make_grid(num_pieces, along, [](double s, double t) { return Eigen::Vector3d(num_pieces * s, t, 0); });
  for (int i = 1; i < num_pieces; ++i) {
    const std::vector<int> seam = test::grid_column(num_pieces, along, i);
    test::add_seam(input, seam);
    test::add_wire(input, seam, 0.01);
  }
  for (const Piece& piece : flatten(input).pieces) {
    ASSERT_FALSE(piece.error) << piece.error->what();
    EXPECT_LT(piece.report.constraint_residual, 1e-13);
  }
}

/// All gores are equal, so all seams get the length that a single gore with two equal sides would get.
TEST(ElasticSeams, ABallOfGoresIsLikeOneGoreWithEqualSides) {
  const FlattenResult ball = flatten(gores(kInfinity));
  for (const SeamReport& seam : ball.seams) EXPECT_NEAR(seam.variation, ball.seams[0].variation, 1e-4);
  // If the seams of the ball have the found lengths as nominal lengths, the gores get the same shape.
  const FlattenResult eased = flatten(gores(0, ball.seams[0].variation));
  EXPECT_NEAR(eased.pieces[0].metrics.arap_energy, ball.pieces[0].metrics.arap_energy,
              1e-4 * ball.pieces[0].metrics.arap_energy);
  EXPECT_NEAR(eased.seams[0].length_2d[0], ball.seams[0].length_2d[0], 1e-3 * ball.seams[0].length_3d);
}

TEST(ElasticSeams, DoNotDependOnTheNumbering) {
  FlattenInput input = sheet_and_saddle();
  test::add_wire(input, seam_of_sheets(), 0.03);
  const FlattenResult result = flatten(input);
  expect_good(input, result);
  const FlattenResult other = flatten(test::disguised(input));
  EXPECT_NEAR(other.seams.at(0).variation, result.seams.at(0).variation, 1e-4);
  EXPECT_NEAR(objective_of(other), objective_of(result), 1e-7 * objective_of(result));
}

TEST(ElasticSeams, AreReusedTogether) {
  const FlattenInput input = gores(0.02);
  Cache cache;
  const FlattenResult fresh = flatten(input, {}, {}, &cache);
  EXPECT_EQ(cache.size(), 6);
  const FlattenResult known = flatten(input, {}, {}, &cache);
  EXPECT_EQ(known.reused_pieces, 6);
  EXPECT_EQ(known.corner_uv, fresh.corner_uv);
  EXPECT_EQ(flatten(input).corner_uv, fresh.corner_uv) << "the same without a cache";
  FlattenInput other = input;
  other.wires[0].tolerance = 0.01;
  const FlattenResult changed = flatten(other, {}, {}, &cache);
  EXPECT_EQ(changed.reused_pieces, 0);
  EXPECT_EQ(changed.corner_uv, flatten(other).corner_uv);
}

TEST(ElasticSeams, HaveTheSameVariationIfMeasured) {
  const FlattenInput input = gores(0.02);
  const FlattenResult result = flatten(input);
  const FlattenResult measured = measure(input, result.corner_uv);
  for (std::size_t s = 0; s < result.seams.size(); ++s) {
    EXPECT_NEAR(measured.seams[s].variation, result.seams[s].variation, 1e-9);
  }
  for (const Piece& piece : measured.pieces) EXPECT_FALSE(piece.error) << piece.error->what();
}

TEST(ElasticSeams, KeepGuaranteesWhenCanceled) {
  const FlattenInput input = gores(0.05);
  int asked = 0;
  flatten(input, {}, [&](const std::string&, double) { return ++asked > 0; });
  for (const int last : {asked / 2, asked - 3}) {
    int left = last;
    const FlattenResult result = flatten(input, {}, [&](const std::string&, double) { return left-- > 0; });
    EXPECT_EQ(test::broken_guarantees(input, {}, result), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace wirewarp::test_elastic_seams
