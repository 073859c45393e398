// SPDX-License-Identifier: GPL-3.0-or-later
// Compares pieces of stretched fabric and of thick material with exact formulas.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/planar.h"
#include "error_of.h"
#include "test_meshes.h"

namespace wirewarp::test_stretch {
namespace {

constexpr double kWeft = 0.25, kWarp = 0.1;
constexpr double kRelative = 1e-8;

Options stretched(double weft, double warp, double shear = 0.05) {
  Options options;
  options.cloth.emplace();
  options.cloth->shear = shear;
  options.cloth->stretch = {weft, warp};
  return options;
}

/// Returns the flat length divided by the length on the surface, for a line at the angle ψ from the weft:
/// √(cos²ψ/(1+c_weft)² + sin²ψ/(1+c_warp)²).
double share_at(double angle) { return std::hypot(std::cos(angle) / (1 + kWeft), std::sin(angle) / (1 + kWarp)); }

FlattenResult flat(const FlattenInput& input, const Options& options) {
  FlattenResult result = flatten(input, options);
  for (const Piece& piece : result.pieces) EXPECT_FALSE(piece.error) << piece.report.message;
  return result;
}

double flat_length(const FlattenResult& result, const std::vector<int>& chain) {
  const Piece& piece = result.pieces.at(0);
  const auto place = [&](int vertex) -> Eigen::RowVector2d {
    return piece.vertices.row(test::position_in(piece.source_vertex, vertex));
  };
  double length = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) length += (place(chain[i]) - place(chain[i - 1])).norm();
  return length;
}

double length_3d(const FlattenInput& input, const std::vector<int>& chain) {
  double length = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    length += (input.vertices.row(chain[i]) - input.vertices.row(chain[i - 1])).norm();
  }
  return length;
}

void expect_share(const FlattenInput& input, const FlattenResult& result, const std::vector<int>& chain, double share) {
  const double expected = share * length_3d(input, chain);
  EXPECT_NEAR(flat_length(result, chain), expected, kRelative * expected);
}

constexpr int kAcross = 8, kUpright = 6;

/// Returns a part of a cylinder with its grain along the axis.
FlattenInput cylinder() {
  FlattenInput input = test::cylinder_patch(kAcross, kUpright, 1, 2, 1.5);
  test::add_wire(input, test::grid_column(kAcross, kUpright, kAcross / 2));
  return input;
}

TEST(Stretch, ShrinksACylinderAlongTheGrain) {
  const FlattenInput input = cylinder();
  const FlattenResult result = flat(input, stretched(kWeft, kWarp));
  EXPECT_LT(result.pieces.at(0).metrics.cloth_energy, 1e-16);
  expect_share(input, result, test::grid_row(kAcross, 0), 1 / (1 + kWeft));
  expect_share(input, result, test::grid_row(kAcross, kUpright), 1 / (1 + kWeft));
  for (const int column : {0, kAcross / 2, kAcross}) {
    expect_share(input, result, test::grid_column(kAcross, kUpright, column), 1 / (1 + kWarp));
  }
  const Metrics& metrics = result.pieces[0].metrics;
  EXPECT_NEAR(metrics.face_weft_strain.maxCoeff(), kWeft, 1e-8) << "when worn, it has the requested stretch";
  EXPECT_NEAR(metrics.face_warp_strain.minCoeff(), kWarp, 1e-8);
}

TEST(Stretch, ShrinksACylinderOnTheBias) {
  const FlattenInput input = cylinder();
  Options options = stretched(kWeft, kWarp);
  options.grain_angle = kPi / 4;
  const FlattenResult result = flat(input, options);
  EXPECT_LT(result.pieces.at(0).metrics.cloth_energy, 1e-16);
  const double share = std::sqrt((1 / ((1 + kWeft) * (1 + kWeft)) + 1 / ((1 + kWarp) * (1 + kWarp))) / 2);
  expect_share(input, result, test::grid_row(kAcross, 0), share);
  expect_share(input, result, test::grid_column(kAcross, kUpright, 0), share);
}

TEST(Stretch, ShrinksACone) {
  const double half_angle = 0.5, around = 2.5;
  FlattenInput input = test::cone_patch(kAcross, kUpright, 1, 3, half_angle, around);
  test::add_wire(input, test::grid_column(kAcross, kUpright, kAcross / 2));
  const FlattenResult result = flat(input, stretched(kWeft, kWarp));
  EXPECT_LT(result.pieces.at(0).metrics.cloth_energy, 1e-16);
  // The mesh is a pyramid. Unfolded, it spans this angle at the apex.
  const double opening = kAcross * 2 * std::asin(std::sin(half_angle) * std::sin(around / kAcross / 2));
  for (const int leg : {0, kAcross}) {
    expect_share(input, result, test::grid_column(kAcross, kUpright, leg), share_at(kPi / 2 - opening / 2));
  }
}

TEST(Stretch, EqualInAllDirectionsShrinksAGore) {
  const double stretch = 0.2;
  const FlattenInput sphere = test::quarter_sphere(6);
  const Piece loose = flat(sphere, stretched(0, 0)).pieces.at(0);
  const Piece tight = flat(sphere, stretched(stretch, stretch)).pieces.at(0);
  for (std::size_t i = 0; i < loose.boundaries.size(); ++i) {
    EXPECT_NEAR((1 + stretch) * tight.boundaries[i].length_2d, loose.boundaries[i].length_2d, 1e-8);
  }
  const auto centered = [](const Piece& piece) -> Positions2 {
    return piece.vertices.rowwise() - piece.vertices.colwise().mean();
  };
  EXPECT_LT(((1 + stretch) * centered(tight) - centered(loose)).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_NEAR((1 + stretch) * (1 + stretch) * tight.report.objective, loose.report.objective,
              1e-8 * loose.report.objective);
}

/// Returns two flat sheets of 2 by 2. The grain wire of one sheet is along the seam, and the grain wire of the other
/// sheet is across the seam.
FlattenInput sheets_with_crossed_grain() {
  FlattenInput input = test::flat_rectangle(8, 4, 4, 2);
  test::add_seam(input, test::grid_column(8, 4, 4));
  test::add_wire(input, test::grid_column(8, 4, 2));
  test::add_wire(input, test::section(test::grid_row(8, 2), 4, 8));
  return input;
}

TEST(Stretch, TheSidesOfASeamShrinkByTheirMeanWithAWarning) {
  const FlattenInput input = sheets_with_crossed_grain();
  const FlattenResult result = flat(input, stretched(0.1, 0.06));
  const SeamReport& seam = result.seams.at(0);
  for (const double length : seam.length_2d) EXPECT_NEAR(length, 2 * (1 / 1.1 + 1 / 1.06) / 2, 1e-8);
  EXPECT_LT(seam.mismatch, 1e-9);
  for (const Piece& piece : result.pieces) {
    ASSERT_EQ(piece.report.warnings.size(), 1U);
    test::expect_words(piece.report.warnings[0], "5.66% to 9.09% shorter");
  }
}

TEST(Stretch, AnEaseReplacesTheStretch) {
  FlattenInput input = cylinder();
  test::add_wire(input, test::grid_row(kAcross, 0));
  input.wires.back().ease = -0.15;
  const FlattenResult result = flat(input, stretched(kWeft, kWarp));
  expect_share(input, result, test::grid_row(kAcross, 0), 1 - 0.15);
  EXPECT_LT(flat_length(result, test::grid_row(kAcross, kUpright)),
            (1 - 0.15) * length_3d(input, test::grid_row(kAcross, kUpright)));
}

TEST(Stretch, ElasticSeamsHaveTheirToleranceAroundTheStretchedLength) {
  const double tolerance = 0.02, stretch = 0.2;
  const FlattenResult result = flat(test::sphere_of_gores(4, 3, 8, tolerance), stretched(stretch, stretch));
  for (const SeamReport& seam : result.seams) {
    EXPECT_LT(seam.mismatch, 1e-9 * seam.length_3d);
    const double h = seam.length_2d[0] * (1 + stretch) / seam.length_3d - 1;
    EXPECT_GT(std::abs(h), 1e-3);
    EXPECT_LE(std::abs(h), tolerance + 1e-9);
  }
}

TEST(Stretch, FinishedPiecesKeepTheirLengthsWhenCanceled) {
  const FlattenInput input = sheets_with_crossed_grain();
  int asked = 0;
  const FlattenResult whole =
      flatten(input, stretched(0.1, 0.06), [&](const std::string&, double) { return ++asked > 0; });
  int finished = 0;
  for (int last = 0; last < asked; ++last) {
    int left = last;
    const FlattenResult result =
        flatten(input, stretched(0.1, 0.06), [&](const std::string&, double) { return left-- > 0; });
    for (std::size_t p = 0; p < result.pieces.size(); ++p) {
      const Piece& piece = result.pieces[p];
      if (piece.error) {
        EXPECT_EQ(piece.error->code, ErrorCode::cancelled) << piece.error->what();
        continue;
      }
      ++finished;
      const std::vector<BoundaryReport>& expected = whole.pieces.at(p).boundaries;
      ASSERT_EQ(piece.boundaries.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(piece.boundaries[i].length_2d, expected[i].length_2d, kRelative * expected[i].length_2d)
            << "canceled after " << last << " of " << asked << " questions";
      }
    }
  }
  EXPECT_GT(finished, 0) << "no piece was ever compared";
}

/// Adds wires along all inner rows of a grid and, if along_columns is true, along all inner columns. The stretch does
/// not shorten these wires, because they have an ease.
FlattenInput with_eased_wires(FlattenInput grid, int nx, int ny, double ease, bool along_columns) {
  for (int j = 1; j < ny; ++j) test::add_wire(grid, test::grid_row(nx, j));
  for (int i = 1; along_columns && i < nx; ++i) test::add_wire(grid, test::grid_column(nx, ny, i));
  for (Wire& wire : grid.wires) wire.ease = ease;
  return grid;
}

constexpr double kShorter = 0.3;                     // negative ease of wires, which flips their piece
constexpr double kFitting = 1 / (1 - kShorter) - 1;  // with this stretch, the outline fits these wires

FlattenInput sheet_with_short_wires() {
  const int n = 6;
  return with_eased_wires(test::flat_rectangle(n, n, 1, 1), n, n, -kShorter, true);
}

/// Returns the only piece, flattened with the stretch. Expects that the piece is flipped without the stretch.
Piece flat_although_flipped(const FlattenInput& input, double stretch, int max_factorizations = 100) {
  Options options = stretched(0, 0);
  options.max_factorizations = max_factorizations;
  const std::optional<FlattenError> before = flatten(input, options).pieces.at(0).error;
  EXPECT_TRUE(before && before->code == ErrorCode::flipped_faces);
  options.cloth->stretch = {stretch, stretch};
  return flatten(input, options).pieces.at(0);
}

TEST(Stretch, AFlippedPieceIsGoodIfItsOutlineShrinksToItsWires) {
  const Piece piece = flat_although_flipped(sheet_with_short_wires(), kFitting);
  EXPECT_FALSE(piece.error) << piece.report.message;
  EXPECT_LT(piece.metrics.cloth_energy, 1e-16);
  EXPECT_NEAR(piece.metrics.area_2d, (1 - kShorter) * (1 - kShorter) * piece.metrics.area_3d, 1e-9);
}

TEST(Stretch, AFlippedPieceMayOverlapItselfAfterwards) {
  // This part of a cone spans 1.1 turns in the plane, and its wires allow no other shape. So it overlaps itself.
  const int nx = 16, ny = 3;
  const FlattenInput cone = test::cone_patch(nx, ny, 1, 3, std::asin(7.0 / 8), 1.1 * 2 * kPi * 8 / 7);
  const Piece piece = flat_although_flipped(with_eased_wires(cone, nx, ny, -kShorter, true), kFitting);
  EXPECT_FALSE(test::expect_error(piece.error, ErrorCode::overlapping_faces).elements.proposed_seams.empty());
  EXPECT_NEAR(piece.metrics.area_2d, (1 - kShorter) * (1 - kShorter) * piece.metrics.area_3d, 1e-9);
}

TEST(Stretch, AFlippedPieceIsSolvedFromScratchIfItsOldShapeIsTooFarAway) {
  const int n = 3;
  const double stretch = 0.3;
  const FlattenInput hill = test::make_grid(n, n, [](double s, double t) -> Eigen::Vector3d {
    return {s, t, 0.5 * std::exp(-8 * ((s - 0.5) * (s - 0.5) + (t - 0.5) * (t - 0.5)))};
  });
  const Piece piece = flat_although_flipped(with_eased_wires(hill, n, n, 0.7, false), stretch);
  test::expect_error(piece.error, ErrorCode::flipped_faces);
  for (const BoundaryReport& boundary : piece.boundaries) {
    EXPECT_NEAR(boundary.length_2d, boundary.length_3d / (1 + stretch), kRelative * boundary.length_3d);
  }
}

TEST(Stretch, AFlippedPieceWithoutAShapeNamesTheLimitIfItWasReached) {
  for (const int max_factorizations : {2, 100}) {
    const Piece piece = flat_although_flipped(sheet_with_short_wires(), -0.3, max_factorizations);
    const FlattenError error = test::expect_error(piece.error, ErrorCode::infeasible_lengths);
    EXPECT_FALSE(error.has_layout);
    EXPECT_EQ(error.arguments.count("max_factorizations") > 0, max_factorizations == 2);
    EXPECT_LE(piece.report.factorizations, 2 * max_factorizations) << "one limit for each of two stages";
  }
}

TEST(Stretch, ShrinksAPlateWithHoles) {
  const FlattenInput input = test::flat_plate_with_two_holes(4);
  Options options = stretched(kWeft, kWarp);
  options.orientation = Orientation::up;
  options.up = {0, 1, 0};
  const Piece piece = flat(input, options).pieces.at(0);
  EXPECT_NEAR(piece.metrics.area_2d, piece.metrics.area_3d / ((1 + kWeft) * (1 + kWarp)), 1e-9);
}

TEST(Stretch, OutOfRangeIsRefused) {
  for (const double stretch : {-1.0, -0.6, 5.0, std::numeric_limits<double>::quiet_NaN()}) {
    for (const Options& options : {stretched(stretch, 0), stretched(0, stretch)}) {
      const FlattenError error = test::error_of([&] { check_options(options); });
      EXPECT_EQ(error.code, ErrorCode::invalid_option);
      test::expect_words(error, "stretch is");
    }
  }
}

constexpr double kRadius = 2;

FlattenInput tube() {
  FlattenInput input = test::cylinder_tube(24, 6, kRadius, 3);
  test::add_seam(input, test::tube_line(24, 6, 0));
  return input;
}

TEST(Thickness, ChangesTheWidthOfACylinderByHalfTheThicknessOverTheRadius) {
  const FlattenInput input = tube();
  const double thickness = 0.1, around = length_3d(input, test::tube_ring(24, 3));
  const auto width = [&](Surface surface) {
    Options options;
    options.thickness = thickness;
    options.surface = surface;
    const Piece piece = flat(input, options).pieces.at(0);
    EXPECT_LT(piece.metrics.arap_energy, 1e-20);
    return piece.metrics.area_2d / 3;
  };
  EXPECT_NEAR(width(Surface::inside), around * (1 + thickness / (2 * kRadius)), 1e-9);
  EXPECT_NEAR(width(Surface::middle), around, 1e-9);
  EXPECT_NEAR(width(Surface::outside), around * (1 - thickness / (2 * kRadius)), 1e-9);
}

/// A pillow of height 0. The normals of its two sides cancel out along the seam, in any orientation.
TEST(Thickness, MovesNoVertexWhoseNormalsCancelOut) {
  FlattenInput input =
      test::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 0}},
                    {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  input.vertices = (input.vertices * turn.toRotationMatrix()).eval();
  test::add_seam(input, {0, 1, 2, 3, 0});
  Options options;
  options.thickness = 0.2;
  for (const SeamReport& seam : flat(input, options).seams) EXPECT_NEAR(seam.length_3d, 4, 1e-12);
}

TEST(Thickness, TooLargeForTheCurvatureIsRefused) {
  Options options;
  options.thickness = 2 * kRadius + 0.1;
  options.surface = Surface::outside;
  const FlattenError error = test::error_of([&] { flatten(tube(), options); });
  EXPECT_EQ(error.code, ErrorCode::invalid_option);
  EXPECT_EQ(error.elements.faces.size(), 2U * 24 * 6);
  for (const double thickness : {-1.0, std::numeric_limits<double>::infinity()}) {
    options.thickness = thickness;
    EXPECT_THROW(check_options(options), FlattenError);
  }
}

}  // namespace
}  // namespace wirewarp::test_stretch
