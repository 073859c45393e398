// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the judge reports every spoiled shape, length, layout and error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "judge.h"
#include "judge_case.h"
#include "test_meshes.h"

namespace wirewarp::test_judge {
namespace {

using test::expect_broken;
using test::expect_broken_expectation;
using test::fail;
using test::flattened;
using test::JudgeCase;
using test::moved_vertex;
using test::two_sheets;

TEST(Judge, ReportsFacesThatAreNotInOnePiece) {
  expect_broken("is in two pieces", two_sheets(), [](JudgeCase& c) {
    c.result.pieces.at(1).source_face.at(0) = c.result.pieces.at(0).source_face.at(0);
  });
  for (const char* sentence : {"a face is in no piece", "source_face has wrong size"}) {
    expect_broken(sentence, two_sheets(), [](JudgeCase& c) { c.result.pieces.at(0).source_face.pop_back(); });
  }
}

TEST(Judge, ReportsDifferentOrMissingCoordinates) {
  expect_broken("piece and corner_uv differ", two_sheets(),
                [](JudgeCase& c) { c.result.pieces.at(0).vertices(0, 0) += 1e-6; });
  expect_broken("piece 0 has no error and no coordinates", two_sheets(), [](JudgeCase& c) {
    for (const int f : c.result.pieces.at(0).source_face) c.result.corner_uv.row(f).setConstant(std::nan(""));
  });
}

TEST(Judge, ReportsFlippedFacesAndTornEdges) {
  expect_broken("is flipped", two_sheets(), moved_vertex(0, 1 + 9, 5, 0));  // a vertex not on any line
  expect_broken("torn at", two_sheets(), [](JudgeCase& c) { c.result.corner_uv(16 + 3, 0) += 1e-6; });
}

TEST(Judge, ReportsOverlappingFaces) {
  // A strip that runs twice around a cone makes 1.75 turns in the plane and overlaps itself, unless its shape is bent.
  Options unbent;
  unbent.method = Method::wirewarping;
  const JudgeCase cone = flattened(test::cone_patch(48, 2, 1, 2, std::asin(7.0 / 8), 4 * kPi), unbent);
  ASSERT_TRUE(cone.result.pieces.at(0).error);
  ASSERT_EQ(cone.result.pieces[0].error->code, ErrorCode::overlapping_faces);
  expect_broken("overlap", cone, [](JudgeCase& c) { c.result.pieces[0].error.reset(); });
}

TEST(Judge, ReportsWrongLengths) {
  const int corner = 0, on_rigid = 1 + 9 * 4, on_elastic = 2 + 9 * 2;
  expect_broken("outline 0-", two_sheets(), moved_vertex(0, corner, 1e-6, 1e-6));
  expect_broken("wire \"rigid\" breaks", two_sheets(), moved_vertex(0, on_rigid, 1e-6, 1e-6));
  expect_broken("wire \"elastic\" breaks", two_sheets(), moved_vertex(0, on_elastic, 1e-6, 1e-6));
  expect_broken("wire \"elastic\" breaks", two_sheets(), [](JudgeCase& c) { c.input.wires.at(1).tolerance = 1e-5; });
}

TEST(Judge, ReportsWrongLengthsOfFaultyPieces) {
  // Pieces that overlap themselves have exact lengths. The error of such a piece must suggest a seam inside the piece.
  const VertexPair inside[2]{{10, 11}, {14, 15}};
  JudgeCase faulty = two_sheets();
  for (const int number : {0, 1}) {
    fail(faulty, ErrorCode::overlapping_faces, number);
    faulty.result.pieces[number].error->elements.proposed_seams = {inside[number]};
  }
  const int corner = 0, on_the_seam = 4, on_rigid = 1 + 9 * 4, on_elastic = 2 + 9 * 2;
  expect_broken("outline 0-", faulty, moved_vertex(0, corner, 1e-6, 1e-6));
  expect_broken("outline 4-", faulty, moved_vertex(1, on_the_seam, 1e-6, 1e-6));
  expect_broken("wire \"rigid\" breaks", faulty, moved_vertex(0, on_rigid, 1e-6, 1e-6));
  expect_broken("wire \"elastic\" breaks", faulty, moved_vertex(0, on_elastic, 1e-6, 1e-6));
}

TEST(Judge, ReportsFailuresThatLegalInputMustNotHave) {
  for (const ErrorCode code : {ErrorCode::not_solvable, ErrorCode::lengths_not_kept}) {
    const std::string sentence = std::string("a piece fails with ") + describe(code).name;
    expect_broken_expectation(sentence, two_sheets(), [&](JudgeCase& c) { fail(c, code); });
  }
  const auto fail_by_mesh = [](JudgeCase& c) { fail(c, ErrorCode::zero_area_face); };
  expect_broken_expectation("legal input has the error zero_area_face", two_sheets(), fail_by_mesh);
  JudgeCase faulty = two_sheets();
  fail_by_mesh(faulty);
  const auto reported =
      test::broken_expectations(faulty.input, faulty.options, faulty.result, ErrorCode::zero_area_face);
  EXPECT_EQ(reported, std::vector<std::string>{}) << "the fault that was added to the input";
}

TEST(Judge, ReportsPiecesThatUnfoldButAreNotFlat) {
  const JudgeCase patch = flattened(test::cylinder_patch(6, 4, 1, 2, 1));
  expect_broken_expectation("a piece that unfolds is distorted", patch,
                            [](JudgeCase& c) { c.result.corner_uv *= 1 + 1e-5; });
  expect_broken_expectation("a piece that unfolds has the error infeasible_lengths", patch,
                            [](JudgeCase& c) { fail(c, ErrorCode::infeasible_lengths); });
}

TEST(Judge, ChecksTheLengthsOfAStretchedFabric) {
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

TEST(Judge, ChecksTheShapeOfAStretchedPieceThatUnfolds) {
  const FlattenInput input = test::cylinder_patch(4, 3, 1, 2, 1);
  Options options;
  options.cloth.emplace();
  const FlattenResult unstretched = flatten(input, options);
  options.cloth->stretch = {0.2, 0.05};
  FlattenResult result = flatten(input, options);
  const auto expectations = [&] {
    return test::broken_expectations(input, options, result, std::nullopt, &unstretched);
  };
  EXPECT_EQ(expectations(), std::vector<std::string>{});
  result.corner_uv(0, 0) += 1e-3;
  EXPECT_EQ(expectations().size(), 1U);
  result.pieces.at(0).error.emplace(ErrorCode::overlapping_faces, "It overlaps itself.");
  EXPECT_EQ(expectations().size(), 1U);
}

// Tests that the judge reports pieces that are misplaced or not upright.

using test::moved;
using test::turned;

TEST(Judge, ReportsPiecesTooClose) {
  const JudgeCase packed = flattened(two_sheets().input);
  const Eigen::RowVector2d apart = packed.result.pieces.at(1).vertices.row(0) - packed.result.pieces[0].vertices.row(0);
  expect_broken("closer together than the gap", packed, moved(1, -apart.x(), -apart.y()));
  expect_broken("closer together than the gap", two_sheets(), moved(1, -1e-6, 0));
}

TEST(Judge, ReportsRowsOutOfOrder) {
  const std::string out_of_order = "pieces in a row are not in their order";
  expect_broken(out_of_order, two_sheets(),
                [](JudgeCase& c) { std::swap(c.result.pieces.at(0), c.result.pieces.at(1)); });
  expect_broken(out_of_order, two_sheets(), moved(1, 1e-6, 0));
  expect_broken("are not on one line", two_sheets(), moved(1, 0, 1e-6));
}

TEST(Judge, ReportsWiresThatAreNotUpright) {
  for (const double angle : {1e-5, kPi}) {
    expect_broken("the grain is not upright", two_sheets(), turned(0, angle));
  }
  FlattenInput input = test::saddle(4, 0.2);
  test::add_wire(input, test::grid_row(4, 2));
  expect_broken("the first wire is not upright", flattened(input), turned(0, 1e-5));
}

TEST(Judge, ReportsOutlinesThatAreNotUpright) {
  JudgeCase sheets = two_sheets();
  sheets.input.wires.clear();
  expect_broken("the longest chain of the outline is not upright", flattened(sheets.input), turned(0, 1e-5));
  const FlattenInput rectangle = test::flat_rectangle(4, 3, 2, 1);
  expect_broken("the box of the longest chain of the outline is not upright", flattened(rectangle), turned(0, kPi / 2));
  Options options;
  options.orientation = Orientation::boundary;
  expect_broken("no straight section of the outline is upright", flattened(rectangle, options), turned(0, 0.1));
}

TEST(Judge, ReportsTheLongestChainEvenIfTwoShorterChainsAreEqual) {
  // A trapezoid cut into three pieces. The middle piece has two sides of length 0.53 along the seams, and ends of 0.67
  // and 1.
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
  expect_broken("the longest chain of the outline is not upright", trapezoid, turned(number, 1e-5));
}

TEST(Judge, ReportsPiecesThatDoNotRise) {
  Options options;
  options.orientation = Orientation::up;
  for (const double angle : {1e-5, kPi}) {
    expect_broken("the direction up in space is not up in the piece",
                  flattened(test::cylinder_patch(6, 4, 1, 2, 1), options), turned(0, angle));
  }
  options.orientation = Orientation::grain;
  FlattenInput patch = test::cylinder_patch(6, 4, 1, 2, 1);
  expect_broken("the direction up in space is not up in the piece", flattened(patch, options), turned(0, 1e-5));
  test::add_wire(patch, test::grid_row(6, 2));
  options.grain = 0;
  expect_broken("the grain is not upright", flattened(patch, options), turned(0, 1e-5));
}

TEST(Judge, ReportsChangesByALayout) {
  const JudgeCase sheets = two_sheets();
  const auto reported = [&](const FlattenResult& other) {
    return test::differences_of_layout(sheets.input, sheets.options, sheets.result, other);
  };
  using Sentences = std::vector<std::string>;
  EXPECT_EQ(reported(sheets.result), Sentences{});
  JudgeCase other = sheets;
  turned(0, 1)(other);
  EXPECT_EQ(reported(other.result), Sentences{});

  JudgeCase fewer = sheets;
  fewer.result.pieces.pop_back();
  EXPECT_EQ(reported(fewer.result), Sentences{"the layout changes the number of pieces"});
  JudgeCase failed = sheets;
  test::fail(failed, ErrorCode::not_solvable);
  EXPECT_EQ(reported(failed.result), Sentences{"the layout changes the outcome of piece 0"});
  JudgeCase longer = sheets;
  longer.result.pieces[1].vertices *= 1 + 1e-12;
  EXPECT_EQ(reported(longer.result), Sentences{"the layout changes lengths"});
}

// Tests that the judge reports errors that do not fit their piece.

const VertexPair kInside{10, 11}, kOnTheSeam{4, 13};  // edges of two_sheets()

/// Returns two_sheets() with an error in piece 0, which says that the wires contradict one another and suggests a
/// tolerance.
JudgeCase contradicting() {
  JudgeCase sheets = test::two_sheets();
  fail(sheets, ErrorCode::infeasible_lengths);
  sheets.result.pieces[0].error->elements.proposed_tolerances = {{1, 0.05}};
  return sheets;
}

/// Spoils the error of contradicting(), and expects that broken_guarantees() reports the sentence.
void expect_reported(const std::function<void(FlattenError&, const FlattenResult&)>& spoil,
                     const std::string& sentence) {
  expect_broken(sentence, contradicting(), [&](JudgeCase& c) { spoil(*c.result.pieces[0].error, c.result); });
}

TEST(Judge, ReportsElementsOfAnotherPiece) {
  const std::string sentence = "names elements of another piece";
  expect_reported([](FlattenError& e, const FlattenResult&) { e.elements.vertices = {8}; }, sentence);
  expect_reported([](FlattenError& e, const FlattenResult&) { e.elements.edges = {{7, 8}}; }, sentence);
  expect_reported(
      [](FlattenError& e, const FlattenResult& r) { e.elements.faces = {r.pieces.at(1).source_face.at(0)}; }, sentence);
}

TEST(Judge, ReportsProposalsThatFixNothing) {
  const auto propose = [](const std::vector<VertexPair>& seams, const std::vector<ProposedTolerance>& tolerances) {
    return [=](FlattenError& e, const FlattenResult&) {
      e.elements.proposed_seams = seams;
      e.elements.proposed_tolerances = tolerances;
    };
  };
  expect_reported(propose({kOnTheSeam}, {}), "proposed seam 4-13 does not cut the piece");
  expect_reported(propose({}, {{2, 0.05}}), "a tolerance is proposed for other, which is not in the piece");
  expect_reported(propose({}, {{1, 0.02}}), "the tolerance proposed for elastic is not larger than its own");
  expect_reported(propose({kInside}, {{1, 0.05}}), "both seams and tolerances are proposed");
  expect_reported(propose({}, {}), "nothing is proposed");
}

TEST(Judge, ReportsCodesThatDoNotFitThePiece) {
  const auto recode = [](ErrorCode code) { return [=](FlattenError& e, const FlattenResult&) { e.code = code; }; };
  expect_reported(recode(ErrorCode::closed_chart), "wrong topology: closed or open");
  expect_reported(recode(ErrorCode::handles), "wrong number of handles");
  expect_reported(recode(ErrorCode::boundary_too_short), "the outline is not too short");
  expect_reported(recode(ErrorCode::boundary_too_short), "no seam is proposed");
  expect_reported(recode(ErrorCode::overlapping_faces), "no seam is proposed");
  expect_reported(recode(ErrorCode::overlapping_faces), "tolerances cannot fix this error");
  expect_reported([](FlattenError& e, const FlattenResult&) { e.has_layout = false; }, "has_layout is wrong");
}

TEST(Judge, ReportsFacesThatAreNotFlipped) {
  expect_reported(
      [](FlattenError& e, const FlattenResult& r) {
        e.code = ErrorCode::flipped_faces;
        e.elements.faces = {r.pieces.at(0).source_face.at(0)};
      },
      "is reported as flipped");
}

TEST(Judge, ReportsMissingSeamProposals) {
  const FlattenInput ball = test::closed_sphere(8, 4);
  for (const FlattenInput& input : {ball, test::cylinder_tube(12, 8, 1, 4)}) {
    expect_broken("no seam is proposed", flattened(input),
                  [](JudgeCase& c) { c.result.pieces.at(0).error->elements.proposed_seams.clear(); });
  }
  expect_broken("wrong topology: closed or open", flattened(ball),
                [](JudgeCase& c) { c.result.pieces.at(0).error->code = ErrorCode::boundary_too_short; });
}

TEST(Judge, ReportsUndocumentedArguments) {
  const FlattenInput input = test::flat_rectangle(2, 2, 1, 1);
  FlattenError error(ErrorCode::infeasible_lengths, "The wires contradict one another.", {{0}, {}, {}});
  using Sentences = std::vector<std::string>;
  error.arguments = ErrorArguments{{"reason", "outline"}, {"has_wires", false}};
  EXPECT_EQ(test::faults_of_error(error, input), Sentences{});
  error.arguments = ErrorArguments{{"factorizations", 1}};  // only a part of a documented name
  EXPECT_EQ(test::faults_of_error(error, input), Sentences{"undocumented argument: factorizations"});
}

TEST(Judge, ReportsErrorsWithoutSentenceOrElements) {
  const FlattenInput input = test::flat_rectangle(2, 2, 1, 1);
  const auto reported = [&](const std::string& message, const ErrorElements& elements) {
    return test::faults_of_error(FlattenError(ErrorCode::infeasible_lengths, message, elements), input);
  };
  using Sentences = std::vector<std::string>;
  const std::string message = "The wires contradict one another.";
  EXPECT_EQ(reported(message, {{0}, {}, {}}), Sentences{});
  for (const char* bad : {"", "No.", "The wires contradict one another"}) {
    EXPECT_EQ(reported(bad, {{0}, {}, {}}), Sentences{std::string("infeasible_lengths has no sentence: ") + bad});
  }
  EXPECT_EQ(reported(message, {}), Sentences{"infeasible_lengths names no element: " + message});
  const std::vector<ErrorElements> not_there{
      {{9}, {}, {}},
      {{-1}, {}, {}},
      {{}, {{0, 9}}, {}},
      {{}, {}, {8}},
      {{}, {}, {-1}},
      {{0}, {}, {}, {{9, 0}}},
      {{0}, {}, {}, {}, {{0, 0.1}}},
  };
  for (const ErrorElements& elements : not_there) {
    EXPECT_EQ(reported(message, elements), Sentences{"infeasible_lengths names elements that the input does not have"});
  }
}

}  // namespace
}  // namespace wirewarp::test_judge
