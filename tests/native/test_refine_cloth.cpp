// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of pieces that are flattened with a fabric.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/planar.h"
#include "error_of.h"
#include "test_meshes.h"

namespace wirewarp::test_refine_cloth {
namespace {

Options with_cloth(const Cloth& cloth) {
  Options options;
  options.cloth = cloth;
  return options;
}

Cloth woven() {
  Cloth cloth;
  cloth.shear = 0.05;
  return cloth;
}

Piece flat_piece(const FlattenInput& input, const Options& options) {
  FlattenResult result = flatten(input, options);
  EXPECT_EQ(result.pieces.size(), 1u);
  EXPECT_FALSE(result.pieces[0].error) << result.pieces[0].report.message;
  EXPECT_EQ(result.pieces[0].report.termination, Termination::converged);
  return std::move(result.pieces[0]);
}

Eigen::RowVector2d chord_of(const Piece& piece, const std::vector<int>& wire) {
  const auto place = [&](int vertex) { return piece.vertices.row(test::position_in(piece.source_vertex, vertex)); };
  return place(wire.back()) - place(wire.front());
}

double largest_shear(const Piece& piece) { return piece.metrics.face_shear_angle.cwiseAbs().maxCoeff(); }

TEST(RefineCloth, DevelopablePiecesHaveNoStrainInAnyFabric) {
  FlattenInput cylinder = test::cylinder_patch(8, 6, 1, 2, 1.5);
  test::add_wire(cylinder, test::grid_column(8, 6, 3));
  for (const ClothPreset& preset : cloth_presets()) {
    SCOPED_TRACE(preset.name);
    const Piece piece = flat_piece(cylinder, with_cloth(preset.cloth));
    EXPECT_LT(piece.metrics.cloth_energy, 1e-20);
    EXPECT_LT(piece.metrics.face_weft_strain.cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(piece.metrics.face_warp_strain.cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(largest_shear(piece), 1e-9);
  }
}

TEST(RefineCloth, AFabricHasLessStrainInItsThreadsThanAPieceWithoutFabric) {
  const FlattenInput sphere = test::quarter_sphere(8);
  const Options options = with_cloth(woven());
  const Piece plain = flat_piece(sphere, {}), piece = flat_piece(sphere, options);
  EXPECT_TRUE(std::isnan(plain.metrics.cloth_energy));
  EXPECT_LT(piece.metrics.face_weft_strain.squaredNorm() + piece.metrics.face_warp_strain.squaredNorm(),
            0.7 * (plain.metrics.face_weft_strain.squaredNorm() + plain.metrics.face_warp_strain.squaredNorm()));
  EXPECT_GT(piece.metrics.arap_energy, plain.metrics.arap_energy);
  EXPECT_GE(piece.report.objective, piece.metrics.cloth_energy);
}

TEST(RefineCloth, AnIsotropicFabricHasTheShapeWithoutFabricForSmallStrains) {
  double difference_before = 0;
  for (const double bend : {0.2, 0.1}) {
    const FlattenInput saddle = test::saddle(8, bend);
    const double plain = flat_piece(saddle, {}).metrics.arap_energy;
    const double difference = std::abs(flat_piece(saddle, with_cloth({})).metrics.arap_energy - plain) / plain;
    EXPECT_LT(difference, 0.1 * bend);
    if (difference_before > 0) {
      EXPECT_LT(difference, difference_before / 2);
    }
    difference_before = difference;
  }
}

TEST(RefineCloth, TheGrainWireHasItsAngle) {
  const FlattenInput sphere = test::quarter_sphere(6);
  for (const double angle : {0.0, kPi / 4}) {
    Options options = with_cloth(woven());
    options.grain_angle = angle;
    const Eigen::RowVector2d chord = chord_of(flat_piece(sphere, options), sphere.wires[0].vertices).normalized();
    EXPECT_NEAR(chord.x(), -std::sin(angle), 1e-9);
    EXPECT_NEAR(chord.y(), std::cos(angle), 1e-9);
  }
}

TEST(RefineCloth, TheBestDirectionHasTheLeastEnergyAndIsAsUprightAsTheFabricAllows) {
  const FlattenInput sphere = test::quarter_sphere(6);
  Options options = with_cloth(woven());
  const double straight = flat_piece(sphere, options).report.objective;
  options.grain_angle = kPi / 4;
  const double bias = flat_piece(sphere, options).report.objective;
  options.orientation = Orientation::best;
  const Piece best = flat_piece(sphere, options);
  EXPECT_GT(std::abs(bias - straight), 0.01 * straight);
  EXPECT_LE(best.report.objective, (1 + 1e-9) * std::min(straight, bias));
  const Eigen::RowVector2d chord = chord_of(best, sphere.wires[0].vertices);
  EXPECT_GE(chord.y(), std::abs(chord.x())) << "weft and warp are alike, so a quarter turn does not change the energy";
}

TEST(RefineCloth, ShearDoesNotGrowAsTheMeshIsRefined) {
  const Options options = with_cloth(woven());
  const double coarse = largest_shear(flat_piece(test::quarter_sphere(16), options));
  const double fine = largest_shear(flat_piece(test::quarter_sphere(32), options));
  EXPECT_LE(fine, coarse);
}

TEST(RefineCloth, ThreadsThatLockShearLess) {
  const FlattenInput sphere = test::quarter_sphere(8);
  Cloth cloth = woven();
  const double free = largest_shear(flat_piece(sphere, with_cloth(cloth)));
  cloth.locking = 0.6;
  ASSERT_GT(free, *cloth.locking);
  EXPECT_LT(largest_shear(flat_piece(sphere, with_cloth(cloth))) - *cloth.locking, 0.5 * (free - *cloth.locking));
}

/// Returns the largest distance between two flat positions of one vertex.
double largest_gap(const Piece& piece) {
  double gap = 0;
  for (std::size_t i = 1; i < piece.source_vertex.size(); ++i) {  // source vertices are in ascending order
    if (piece.source_vertex[i] != piece.source_vertex[i - 1]) continue;
    const auto row = static_cast<Eigen::Index>(i);
    gap = std::max(gap, (piece.vertices.row(row) - piece.vertices.row(row - 1)).norm());
  }
  return gap;
}

TEST(RefineCloth, SlitsOpenOrStayShut) {
  FlattenInput saddle = test::saddle(8, 0.4);
  test::add_seam(saddle, test::section(test::grid_row(8, 3), 3, 5));
  EXPECT_GT(largest_gap(flat_piece(saddle, with_cloth(woven()))), 1e-3) << "it opens, as the sheet is stretched there";
  FlattenInput sphere = test::quarter_sphere(8);
  test::add_seam(sphere, test::section(test::grid_row(8, 12), 1, 3));
  EXPECT_EQ(largest_gap(flat_piece(sphere, with_cloth(woven()))), 0) << "its rims would overlap";
}

TEST(RefineCloth, StrainBeyondTheLimitsIsReported) {
  const FlattenInput sphere = test::quarter_sphere(6);
  Cloth cloth = woven();
  cloth.limits = {1.0, 1.0};
  EXPECT_TRUE(flat_piece(sphere, with_cloth(cloth)).report.warnings.empty());
  cloth.limits = {0.03, 0.03};
  const std::vector<std::string> warnings = flat_piece(sphere, with_cloth(cloth)).report.warnings;
  ASSERT_EQ(warnings.size(), 1u);
  test::expect_words(warnings[0], "The fabric allows 3% and 3%");
}

void expect_refused(const Options& options, const std::string& words) {
  const FlattenError error = test::error_of([&] { check_options(options); });
  EXPECT_EQ(error.code, ErrorCode::invalid_option);
  test::expect_words(error, words);
}

TEST(RefineCloth, ImpossibleFabricsAreRefused) {
  const auto refused = [](const auto& change, const std::string& words) {
    Cloth cloth;
    change(cloth);
    expect_refused(with_cloth(cloth), words);
  };
  refused([](Cloth& cloth) { cloth.weft = 0; }, "weft is 0");
  refused([](Cloth& cloth) { cloth.warp = -1; }, "warp is -1");
  refused([](Cloth& cloth) { cloth.shear = NAN; }, "shear is nan");
  refused([](Cloth& cloth) { cloth.warp = INFINITY; }, "warp is inf");
  refused([](Cloth& cloth) { cloth.shear = 1e-5; }, "no stiffness more than 10000 times another");
  refused([](Cloth& cloth) { cloth.squeeze = 0; }, "squeeze is 0");
  refused([](Cloth& cloth) { cloth.locking = kPi / 2; }, "locking is");
  refused([](Cloth& cloth) { cloth.limits = {0.03, -0.01}; }, "limit is -0.01");
  EXPECT_THROW(cloth_preset("lace"), FlattenError);
}

TEST(RefineCloth, FabricNeedsTheRefinedMethodAndTheBestDirectionNeedsFabric) {
  Options options = with_cloth({});
  options.method = Method::wirewarp_plus_plus;
  expect_refused(options, "must be refined if there is a cloth");
  Options best;
  best.orientation = Orientation::best;
  expect_refused(best, "grain if there is no cloth");
  Options turned;
  turned.grain_angle = 4;
  expect_refused(turned, "grain_angle");
}

}  // namespace
}  // namespace wirewarp::test_refine_cloth
