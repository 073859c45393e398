// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of fixed faults of whole pieces, in their shapes, lengths and errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/planar.h"
#include "error_of.h"
#include "result/guarantee.h"
#include "result/metrics.h"
#include "surface/orientation/rising_direction.h"
#include "test_meshes.h"

namespace wirewarp::bugs_of_pieces_test {
namespace {

// Flat sheets were strained or flipped for two reasons:
// - Beside edges of a millionth of the sheet's size, rounding errors of the bending term hid the other terms.
// - Nets of rigid wires are rigid only to second order, so the solver did not converge.

constexpr double kRounding = 1e-20;  // E at strains of 1e-10, which are rounding errors

void expect_flat_without_strain(const FlattenInput& input) {
  for (const Piece& piece : flatten(input).pieces) {
    EXPECT_FALSE(piece.error) << piece.error->what();
    EXPECT_EQ(piece.report.termination, Termination::converged);
    EXPECT_LE(piece.metrics.arap_energy, kRounding);
  }
}

/// Returns a sheet of width 1 whose columns become narrower towards the left.
FlattenInput graded_sheet(int n, double ratio, double height) {
  return test::make_grid(n, n, [=](double s, double t) -> Eigen::Vector3d {
    return {s > 0 ? std::pow(ratio, n * (1 - s)) : 0, height * t, 0};
  });
}

std::vector<int> first_vertices(const std::vector<int>& line, std::ptrdiff_t count) {
  return {line.begin(), line.begin() + count};
}

TEST(Bugs, AFlatSheetWithASlitIsNotStrainedAndDoesNotOverlapItself) {
  FlattenInput strained = graded_sheet(6, 0.1, 1), overlapping = graded_sheet(8, 0.2, 1);
  test::add_seam(strained, first_vertices(test::grid_column(6, 6, 3), 4));
  test::add_seam(overlapping, first_vertices(test::grid_column(8, 8, 5), 5));
  expect_flat_without_strain(strained);
  expect_flat_without_strain(overlapping);
}

TEST(Bugs, AFlatSheetWithShortEdgesIsNotFlipped) {
  FlattenInput input = graded_sheet(10, 0.1, 20);
  test::add_seam(input, first_vertices(test::grid_row(10, 9), 7));
  test::add_wire(input, test::grid_column(10, 10, 1));
  expect_flat_without_strain(input);
}

TEST(Bugs, AFlatNetOfRigidWiresConverges) {
  FlattenInput input = test::flat_rectangle(2, 5, 34, 5);
  for (const std::vector<int>& edge : {std::vector<int>{6, 10}, {0, 4}, {7, 11}, {7, 10}, {1, 4}, {4, 7}, {6, 7}}) {
    test::add_wire(input, edge);
  }
  for (const std::vector<int>& edge : {std::vector<int>{4, 5}, {1, 5}}) test::add_wire(input, edge, 0.001);
  test::add_seam(input, {10, 11});
  expect_flat_without_strain(input);
}

// With Orientation::up, a flipped piece was upside down. The mean gradient of the height over the piece had the wrong
// sign, because the area of a flipped piece is negative.
TEST(Bugs, AFlippedPieceIsUprightToo) {
  const Charts charts = test::charts_of(test::flat_rectangle(4, 3, 2, 1));
  const Positions2 uv = test::planar_positions(charts.charts.at(0));
  const Positions2 turned_over = uv * Eigen::Vector2d(-1, 1).asDiagonal();
  for (const Positions2& layout : {uv, turned_over}) {
    const Eigen::Vector2d rising = rising_direction(charts.charts[0], layout, {0, 1, 0});
    EXPECT_NEAR((rising.normalized() - Eigen::Vector2d(0, 1)).norm(), 0, 1e-12);
  }
}

// If a face of a ring was flipped, the error suggested only a seam that opens the ring. A dart or a wire with more
// tolerance may help, too.
TEST(Bugs, TheErrorOfARingProposesEveryRemedy) {
  const int around = 16;
  FlattenInput input = test::flat_annulus(around, 4, 1, 3);
  const int inside = test::nearest_vertex(input, {0, 2, 0});
  const int begin = test::nearest_vertex(input, {0, -1, 0}), end = test::nearest_vertex(input, {0, -1.5, 0});
  test::add_wire(input, {begin, end}, 0, "spoke");
  const Chart chart = test::chart_of(input);
  const WireNetwork network = build_wire_network(chart);
  Positions2 uv = test::planar_positions(chart);
  uv(inside, 1) -= 0.7;  // moved onto the next ring
  const auto error = check_guarantee(chart, network, input.wires, uv, std::vector<double>(chart.wire_parts.size(), 0),
                                     measure_metrics(chart, network, uv), {{begin, end}});
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::flipped_faces);
  EXPECT_EQ(error->elements.proposed_seams, (std::vector<VertexPair>{{begin, end}}));
  for (const char* remedy : {"mark seams, such as along edge", "add a seam or a dart there",
                             "remove a nearby wire or give it more tolerance"}) {
    test::expect_words(*error, remedy);
  }
}

// A wire of one vertex that does not exist was refused as too short. The error then named a vertex that is not part of
// the mesh.
TEST(Bugs, AShortWireOfNoVertexIsOutOfRange) {
  FlattenInput input = test::flat_rectangle(1, 1, 1, 1);
  const auto beyond = static_cast<int>(input.vertices.rows());
  test::add_wire(input, {beyond});
  EXPECT_EQ(test::error_of([&] { flatten(input); }).code, ErrorCode::vertex_out_of_range);
}

Options stretched(double weft, double warp) {
  Options options;
  options.cloth.emplace();
  options.cloth->shear = 0.05;
  options.cloth->stretch = {weft, warp};
  return options;
}

/// Returns two sheets of 2 by 2, one with its grain along the seam, the other with its grain across the seam.
FlattenInput sheets_with_crossed_grain(double bump) {
  FlattenInput input = test::make_grid(8, 4, [=](double s, double t) -> Eigen::Vector3d {
    return {4 * s, 2 * t, bump * std::sin(3 * s) * std::sin(3 * t)};
  });
  test::add_seam(input, test::grid_column(8, 4, 4));
  test::add_wire(input, test::grid_column(8, 4, 2));
  const std::vector<int> row = test::grid_row(8, 2);
  test::add_wire(input, {row.begin() + 4, row.end()});
  return input;
}

/// Returns a ruffle around almost a full circle. Without a rule against overlaps, the ends of its flat shape would
/// overlap.
FlattenInput ruffle() {
  return test::make_grid(24, 3, [](double s, double t) -> Eigen::Vector3d {
    const double angle = 0.95 * 2 * kPi * s, radius = 1 + t;
    return {radius * std::cos(angle), radius * std::sin(angle), 0.2 * radius * std::cos(3 * angle)};
  });
}

void expect_good(const FlattenResult& result) {
  for (const Piece& piece : result.pieces) EXPECT_FALSE(piece.error) << piece.error->what();
  for (const SeamReport& seam : result.seams) EXPECT_LT(seam.mismatch, 1e-9 * seam.length_3d);
}

// A single step to the stretched lengths failed for these sheets.
TEST(Bugs, SidesOfASeamThatShrinkVeryDifferentlyGetCommonLengths) {
  for (const double bump : {0.0, 0.6}) {
    FlattenInput input = sheets_with_crossed_grain(bump);
    expect_good(flatten(input, stretched(1, -0.3)));
    test::add_wire(input, test::grid_column(8, 4, 4), 0.02);
    expect_good(flatten(input, stretched(1, -0.3)));
  }
}

TEST(Bugs, AStretchedPieceDoesNotOverlapItself) {
  expect_good(flatten(ruffle(), stretched(0, 0)));
  expect_good(flatten(ruffle(), stretched(0.25, 0.1)));
}

TEST(Bugs, StretchedElasticSeamsHaveTheirEaseIfNoOtherLengthIsFound) {
  FlattenInput input = sheets_with_crossed_grain(0);
  test::add_wire(input, test::grid_column(8, 4, 4), 0.2);
  Options options = stretched(0.3, -0.3);
  options.max_factorizations = 2;  // enough for each piece alone, but not for both together
  const FlattenResult result = flatten(input, options);
  expect_good(result);
  EXPECT_NEAR(result.seams.at(0).length_2d[0], 2 * (1 / 1.3 + 1 / 0.7) / 2, 1e-8);
  for (const Piece& piece : result.pieces) {
    EXPECT_EQ(piece.report.termination, Termination::stalled);
    const std::vector<std::string>& warnings = piece.report.warnings;
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
      return warning.find("keep their nominal lengths") != std::string::npos;
    }));
  }
}

/// Returns two sheets side by side. The left sheet has a bump, and more rigid wires than it can keep without flips.
FlattenInput flipped_beside_good() {
  FlattenInput input = test::make_grid(8, 4, [](double s, double t) -> Eigen::Vector3d {
    return {2 * s, t, 2 * std::exp(-12 * ((2 * s - 0.5) * (2 * s - 0.5) + (t - 0.5) * (t - 0.5)))};
  });
  test::add_seam(input, test::grid_column(8, 4, 4));
  for (const int j : {1, 2, 3}) {
    const std::vector<int> row = test::grid_row(8, j);
    test::add_wire(input, {row.begin(), row.begin() + 5});
  }
  test::add_wire(input, test::grid_column(8, 4, 6));
  return input;
}

// The stretched piece lost its layout and the seams suggested for it.
TEST(Bugs, APieceThatIsFlippedAnywayKeepsItsErrorAndSuggestionUnderAStretch) {
  const FlattenInput input = flipped_beside_good();
  const FlattenResult loose = flatten(input, stretched(0, 0)), tight = flatten(input, stretched(0.2, 0.05));
  const std::optional<FlattenError>&before = loose.pieces.at(0).error, &after = tight.pieces.at(0).error;
  ASSERT_TRUE(before && before->code == ErrorCode::flipped_faces);
  ASSERT_TRUE(after && after->code == ErrorCode::flipped_faces);
  EXPECT_TRUE(after->has_layout);
  EXPECT_EQ(after->elements.proposed_seams, before->elements.proposed_seams);
  EXPECT_FALSE(tight.pieces.at(1).error);
}

// The flipped piece kept its unstretched lengths, so the two sides of its seam differed in length.
TEST(Bugs, TheSidesOfASeamHaveOneLengthBesideAFlippedPiece) {
  for (const double tolerance : {0.0, 0.05}) {
    FlattenInput input = flipped_beside_good();
    if (tolerance > 0) test::add_wire(input, test::grid_column(8, 4, 4), tolerance);
    const FlattenResult result = flatten(input, stretched(0.2, 0.05));
    ASSERT_TRUE(result.pieces.at(0).error && result.pieces[0].error->code == ErrorCode::flipped_faces);
    EXPECT_FALSE(result.pieces.at(1).error);
    const SeamReport& seam = result.seams.at(0);
    // The length is between the lengths of a seam along the weft and of a seam along the warp, within the tolerance.
    EXPECT_GT(seam.length_2d.at(0), (1 - tolerance) * seam.length_3d / 1.2);
    EXPECT_LT(seam.length_2d.at(0), (1 + tolerance) * seam.length_3d / 1.05);
    EXPECT_LT(seam.mismatch, 1e-9 * seam.length_3d);
  }
}

}  // namespace
}  // namespace wirewarp::bugs_of_pieces_test
