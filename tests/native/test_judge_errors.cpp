// SPDX-License-Identifier: GPL-3.0-or-later
// The judge tells of errors that do not fit their piece.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "judge.h"
#include "judge_case.h"
#include "test_meshes.h"

namespace wirewarp::test_judge_errors {
namespace {

using test::expect_broken;
using test::fail;
using test::flattened;
using test::JudgeCase;

const VertexPair kInside{10, 11}, kOnTheSeam{4, 13};  // edges of the two sheets

/// The two sheets, piece 0 with wires that contradict and a tolerance that would mend it.
JudgeCase contradicting() {
  JudgeCase sheets = test::two_sheets();
  fail(sheets, ErrorCode::infeasible_lengths);
  sheets.result.pieces[0].error->elements.proposed_tolerances = {{1, 0.05}};
  return sheets;
}

/// expect_broken() on contradicting(), with its error spoiled.
void expect_told(const std::function<void(FlattenError&, const FlattenResult&)>& spoil, const std::string& sentence) {
  expect_broken(
      contradicting(), [&](JudgeCase& c) { spoil(*c.result.pieces[0].error, c.result); }, sentence);
}

TEST(Judge, ReportsElementsOfAnotherPiece) {
  const std::string sentence = "names elements of another piece";
  expect_told([](FlattenError& e, const FlattenResult&) { e.elements.vertices = {8}; }, sentence);
  expect_told([](FlattenError& e, const FlattenResult&) { e.elements.edges = {{7, 8}}; }, sentence);
  expect_told([](FlattenError& e, const FlattenResult& r) { e.elements.faces = {r.pieces.at(1).source_face.at(0)}; },
              sentence);
}

TEST(Judge, ReportsProposalsThatFixNothing) {
  const auto propose = [](const std::vector<VertexPair>& seams, const std::vector<ProposedTolerance>& tolerances) {
    return [=](FlattenError& e, const FlattenResult&) {
      e.elements.proposed_seams = seams;
      e.elements.proposed_tolerances = tolerances;
    };
  };
  expect_told(propose({kOnTheSeam}, {}), "proposed seam 4-13 does not cut the piece");
  expect_told(propose({}, {{2, 0.05}}), "a tolerance is proposed for other, which is not in the piece");
  expect_told(propose({}, {{1, 0.02}}), "the tolerance proposed for elastic is not larger than its own");
  expect_told(propose({kInside}, {{1, 0.05}}), "both seams and tolerances are proposed");
  expect_told(propose({}, {}), "nothing is proposed");
}

TEST(Judge, ReportsCodesThatDoNotFitThePiece) {
  const auto recode = [](ErrorCode code) { return [=](FlattenError& e, const FlattenResult&) { e.code = code; }; };
  expect_told(recode(ErrorCode::closed_chart), "wrong topology: closed or open");
  expect_told(recode(ErrorCode::handles), "wrong number of handles");
  expect_told(recode(ErrorCode::boundary_too_short), "the outline is not too short");
  expect_told(recode(ErrorCode::boundary_too_short), "no seam is proposed");
  expect_told(recode(ErrorCode::overlapping_faces), "no seam is proposed");
  expect_told(recode(ErrorCode::overlapping_faces), "tolerances cannot fix this error");
  expect_told([](FlattenError& e, const FlattenResult&) { e.has_layout = false; }, "has_layout is wrong");
}

TEST(Judge, ReportsFacesThatAreNotFlipped) {
  expect_told(
      [](FlattenError& e, const FlattenResult& r) {
        e.code = ErrorCode::flipped_faces;
        e.elements.faces = {r.pieces.at(0).source_face.at(0)};
      },
      "is reported as flipped");
}

TEST(Judge, ReportsSeamsThatAreNotProposed) {
  FlattenInput ball = test::sphere_of_gores(2, 4, 4);
  ball.seams.resize(0, 2);
  for (const FlattenInput& input : {ball, test::cylinder_tube(12, 8, 1, 4)}) {
    expect_broken(
        flattened(input), [](JudgeCase& c) { c.result.pieces.at(0).error->elements.proposed_seams.clear(); },
        "no seam is proposed");
  }
  expect_broken(
      flattened(ball), [](JudgeCase& c) { c.result.pieces.at(0).error->code = ErrorCode::boundary_too_short; },
      "wrong topology: closed or open");
}

TEST(Judge, ReportsUndocumentedArguments) {
  const FlattenInput input = test::flat_rectangle(2, 2, 1, 1);
  FlattenError error(ErrorCode::infeasible_lengths, "The wires contradict one another.", {{0}, {}, {}});
  using Sentences = std::vector<std::string>;
  error.arguments = ErrorArguments{{"reason", "outline"}, {"has_wires", false}};
  EXPECT_EQ(test::faults_of_error(error, input), Sentences{});
  error.arguments = ErrorArguments{{"factorizations", 1}};  // part of a documented one
  EXPECT_EQ(test::faults_of_error(error, input), Sentences{"undocumented argument: factorizations"});
}

TEST(Judge, ReportsErrorsWithoutSentenceOrElements) {
  const FlattenInput input = test::flat_rectangle(2, 2, 1, 1);
  const auto told = [&](const std::string& message, const ErrorElements& elements) {
    return test::faults_of_error(FlattenError(ErrorCode::infeasible_lengths, message, elements), input);
  };
  using Sentences = std::vector<std::string>;
  const std::string message = "The wires contradict one another.";
  EXPECT_EQ(told(message, {{0}, {}, {}}), Sentences{});
  for (const char* bad : {"", "No.", "The wires contradict one another"}) {
    EXPECT_EQ(told(bad, {{0}, {}, {}}), Sentences{std::string("infeasible_lengths has no sentence: ") + bad});
  }
  EXPECT_EQ(told(message, {}), Sentences{"infeasible_lengths names no element: " + message});
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
    EXPECT_EQ(told(message, elements), Sentences{"infeasible_lengths names elements that the input does not have"});
  }
}

}  // namespace
}  // namespace wirewarp::test_judge_errors
