// SPDX-License-Identifier: GPL-3.0-or-later
// The judge tells of spoiled shapes and lengths, and of pieces that should have come out flat.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "judge.h"
#include "judge_case.h"
#include "test_meshes.h"

namespace wirewarp::test_judge_shapes {
namespace {

using test::expect_broken;
using test::expect_demanded;
using test::fail;
using test::flattened;
using test::JudgeCase;
using test::move_vertex;
using test::two_sheets;

TEST(Judge, ReportsFacesThatAreNotInOnePiece) {
  const auto name_twice = [](JudgeCase& c) {
    c.result.pieces.at(1).source_face.at(0) = c.result.pieces.at(0).source_face.at(0);
  };
  expect_broken(two_sheets(), name_twice, "is in two pieces");
  const auto leave_out = [](JudgeCase& c) { c.result.pieces.at(0).source_face.pop_back(); };
  expect_broken(two_sheets(), leave_out, "a face is in no piece");
  expect_broken(two_sheets(), leave_out, "source_face has wrong size");
}

TEST(Judge, ReportsDifferentOrMissingCoordinates) {
  expect_broken(
      two_sheets(), [](JudgeCase& c) { c.result.pieces.at(0).vertices(0, 0) += 1e-6; }, "piece and corner_uv differ");
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        for (const int f : c.result.pieces.at(0).source_face) {
          c.result.corner_uv.row(f).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
      },
      "piece 0 has no error and no coordinates");
}

TEST(Judge, ReportsFlippedFaces) {
  const int inside = 1 + 9;  // on no line
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        move_vertex(c, 0, inside, {5, 0});
      },
      "is flipped");
}

TEST(Judge, ReportsOverlappingFaces) {
  // A cone walked around twice: one and three quarters of a turn in the plane, unless the shape is bent.
  Options unbent;
  unbent.method = Method::wirewarping;
  const JudgeCase cone = flattened(test::cone_patch(48, 2, 1, 2, std::asin(7.0 / 8), 4 * kPi), unbent);
  ASSERT_TRUE(cone.result.pieces.at(0).error);
  ASSERT_EQ(cone.result.pieces[0].error->code, ErrorCode::overlapping_faces);
  expect_broken(
      cone, [](JudgeCase& c) { c.result.pieces[0].error.reset(); }, "overlap");
}

TEST(Judge, ReportsTornEdges) {
  expect_broken(
      two_sheets(), [](JudgeCase& c) { c.result.corner_uv(16 + 3, 0) += 1e-6; }, "torn at");
}

TEST(Judge, ReportsWrongLengths) {
  const int corner = 0, on_rigid = 1 + 9 * 4, on_elastic = 2 + 9 * 2;
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        move_vertex(c, 0, corner, {1e-6, 1e-6});
      },
      "outline 0-");
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        move_vertex(c, 0, on_rigid, {1e-6, 1e-6});
      },
      "wire \"rigid\" breaks");
  expect_broken(
      two_sheets(),
      [](JudgeCase& c) {
        move_vertex(c, 0, on_elastic, {1e-6, 1e-6});
      },
      "wire \"elastic\" breaks");
  expect_broken(
      two_sheets(), [](JudgeCase& c) { c.input.wires.at(1).tolerance = 1e-5; }, "wire \"elastic\" breaks");
}

TEST(Judge, ReportsFailuresThatLegalInputMustNotHave) {
  for (const ErrorCode code : {ErrorCode::not_solvable, ErrorCode::lengths_not_kept}) {
    expect_demanded(
        two_sheets(), [&](JudgeCase& c) { fail(c, code); }, std::string("a piece fails with ") + describe(code).name);
  }
  const auto fail_by_mesh = [](JudgeCase& c) { fail(c, ErrorCode::zero_area_face); };
  expect_demanded(two_sheets(), fail_by_mesh, "legal input has the error zero_area_face");
  JudgeCase faulty = two_sheets();
  fail_by_mesh(faulty);
  const auto told = test::broken_expectations(faulty.input, faulty.options, faulty.result, ErrorCode::zero_area_face);
  EXPECT_EQ(told, std::vector<std::string>{}) << "the fault that the input was given";
}

TEST(Judge, ReportsPiecesThatUnfoldButAreNotFlat) {
  const JudgeCase patch = flattened(test::cylinder_patch(6, 4, 1, 2, 1));
  expect_demanded(
      patch, [](JudgeCase& c) { c.result.corner_uv *= 1 + 1e-5; }, "a piece that unfolds is distorted");
  expect_demanded(
      patch, [](JudgeCase& c) { fail(c, ErrorCode::infeasible_lengths); },
      "a piece that unfolds has the error infeasible_lengths");
}

TEST(Judge, KnowsTheLengthsOfAStretchedClothByTheDirectionsWithoutTheStretch) {
  const FlattenInput input = two_sheets().input;
  Options options;
  options.cloth.emplace();
  const FlattenResult unstretched = flatten(input, options);
  options.cloth->stretch = {0.2, 0.05};
  const FlattenResult result = flatten(input, options);
  EXPECT_EQ(test::broken_guarantees(input, options, result, &unstretched), std::vector<std::string>{});
  EXPECT_EQ(test::broken_expectations(input, options, result, std::nullopt, &unstretched), std::vector<std::string>{});
  std::swap(options.cloth->stretch[0], options.cloth->stretch[1]);
  EXPECT_FALSE(test::broken_guarantees(input, options, result, &unstretched).empty());
}

TEST(Judge, KnowsTheShapeOfAStretchedPieceThatUnfolds) {
  const FlattenInput input = test::cylinder_patch(4, 3, 1, 2, 1);
  Options options;
  options.cloth.emplace();
  const FlattenResult unstretched = flatten(input, options);
  options.cloth->stretch = {0.2, 0.05};
  FlattenResult result = flatten(input, options);
  const auto demands = [&] { return test::broken_expectations(input, options, result, std::nullopt, &unstretched); };
  EXPECT_EQ(demands(), std::vector<std::string>{});
  result.corner_uv(0, 0) += 1e-3;
  EXPECT_EQ(demands().size(), 1U);
  result.pieces.at(0).error.emplace(ErrorCode::overlapping_faces, "It covers itself.");
  EXPECT_EQ(demands().size(), 1U);
}

}  // namespace
}  // namespace wirewarp::test_judge_shapes
