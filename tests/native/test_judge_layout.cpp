// SPDX-License-Identifier: GPL-3.0-or-later
// The judge tells of pieces that lie in the wrong place or do not stand upright.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "judge.h"
#include "judge_case.h"
#include "test_meshes.h"

namespace wirewarp::test_judge_layout {
namespace {

using test::expect_broken;
using test::flattened;
using test::JudgeCase;
using test::move_piece;
using test::Spoil;
using test::turn_piece;
using test::two_sheets;

Spoil turned(int piece, double angle) {
  return [=](JudgeCase& c) { turn_piece(c, piece, angle); };
}

TEST(Judge, ReportsPiecesTooClose) {
  JudgeCase packed = two_sheets();
  packed = flattened(packed.input);
  expect_broken(
      packed,
      [](JudgeCase& c) {
        move_piece(c, 1, c.result.pieces.at(0).vertices.row(0) - c.result.pieces.at(1).vertices.row(0));
      },
      "closer together than the gap");
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        move_piece(c, 1, {-1e-6, 0});
      },
      "closer together than the gap");
}

TEST(Judge, ReportsRowsOutOfOrder) {
  expect_broken(
      two_sheets(), [](JudgeCase& c) { std::swap(c.result.pieces.at(0), c.result.pieces.at(1)); },
      "pieces in a row are not in their order");
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        move_piece(c, 1, {1e-6, 0});
      },
      "pieces in a row are not in their order");
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        move_piece(c, 1, {0, 1e-6});
      },
      "are not on one line");
}

TEST(Judge, ReportsWiresThatAreNotUpright) {
  for (const double angle : {1e-5, kPi}) {
    expect_broken(two_sheets(), turned(0, angle), "the grain is not upright");
  }
  FlattenInput input = test::saddle(4, 0.2);
  test::add_wire(input, test::grid_row(4, 2));
  expect_broken(flattened(input), turned(0, 1e-5), "the first wire is not upright");
}

TEST(Judge, ReportsOutlinesThatAreNotUpright) {
  JudgeCase sheets = two_sheets();
  sheets.input.wires.clear();
  expect_broken(flattened(sheets.input), turned(0, 1e-5), "the longest chain of the outline is not upright");
  const FlattenInput rectangle = test::flat_rectangle(4, 3, 2, 1);
  expect_broken(flattened(rectangle), turned(0, kPi / 2), "the box of the longest chain of the outline is not upright");
  Options options;
  options.orientation = Orientation::boundary;
  expect_broken(flattened(rectangle, options), turned(0, 0.1), "no straight section of the outline is upright");
}

TEST(Judge, ReportsTheLongestChainIfShorterOnesAreEquallyLong) {
  // A trapezoid cut into three: its middle piece has two sides of 0.53 along the seams and ends of 0.67 and 1.
  FlattenInput input =
      test::make_grid(6, 2, [](double s, double t) { return Eigen::Vector3d((s - 0.5) * (2 + t), t / 2, 0); });
  for (const int column : {2, 4}) test::add_seam(input, test::grid_column(6, 2, column));
  JudgeCase trapezoid = flattened(input);
  const auto middle = std::find_if(trapezoid.result.pieces.begin(), trapezoid.result.pieces.end(),
                                   [](const Piece& p) { return p.boundaries.size() == 4; });
  ASSERT_NE(middle, trapezoid.result.pieces.end());
  std::sort(middle->boundaries.begin(), middle->boundaries.end(),
            [](const BoundaryReport& a, const BoundaryReport& b) { return a.length_3d < b.length_3d; });
  ASSERT_NEAR(middle->boundaries[0].length_3d, middle->boundaries[1].length_3d, 1e-12);
  const int number = static_cast<int>(middle - trapezoid.result.pieces.begin());
  expect_broken(trapezoid, turned(number, 1e-5), "the longest chain of the outline is not upright");
}

TEST(Judge, ReportsPiecesThatDoNotRise) {
  Options options;
  options.orientation = Orientation::up;
  for (const double angle : {1e-5, kPi}) {
    expect_broken(flattened(test::cylinder_patch(6, 4, 1, 2, 1), options), turned(0, angle),
                  "the direction up in space is not up in the piece");
  }
}

TEST(Judge, ReportsChangesByALayout) {
  const JudgeCase sheets = two_sheets();
  const auto told = [&](const FlattenResult& other) {
    return test::differences_of_layout(sheets.input, sheets.options, sheets.result, other);
  };
  using Sentences = std::vector<std::string>;
  EXPECT_EQ(told(sheets.result), Sentences{});
  JudgeCase moved = sheets;
  turn_piece(moved, 0, 1);
  EXPECT_EQ(told(moved.result), Sentences{});

  JudgeCase fewer = sheets;
  fewer.result.pieces.pop_back();
  EXPECT_EQ(told(fewer.result), Sentences{"the layout changes the number of pieces"});
  JudgeCase failed = sheets;
  test::fail(failed, ErrorCode::not_solvable);
  EXPECT_EQ(told(failed.result), Sentences{"the layout changes the outcome of piece 0"});
  JudgeCase longer = sheets;
  longer.result.pieces[1].vertices *= 1 + 1e-12;
  EXPECT_EQ(told(longer.result), Sentences{"the layout changes lengths"});
}

}  // namespace
}  // namespace wirewarp::test_judge_layout
