// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the judge reports every spoiled shape, length, layout and error. It also judges random cases, of which the
// step `random` has more.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "error_of.h"
#include "judge.h"
#include "random_case.h"
#include "test_meshes.h"

namespace wirewarp::test_judge {
namespace {

using Sentences = std::vector<std::string>;

struct JudgeCase {
  FlattenInput input;
  Options options;
  FlattenResult result;
};

using Spoil = std::function<void(JudgeCase&)>;

Sentences guarantees(const JudgeCase& c) { return test::broken_guarantees(c.input, c.options, c.result); }

Sentences expectations(const JudgeCase& c) {
  return test::broken_expectations(c.input, c.options, c.result, std::nullopt);
}

/// Expects that the judge reports nothing before the change, and a sentence that contains `sentence` after it.
void expect_broken(const std::string& sentence, JudgeCase judged, const Spoil& spoil,
                   Sentences (*judge)(const JudgeCase&) = guarantees) {
  EXPECT_EQ(judge(judged), Sentences{}) << "before it is spoiled";
  spoil(judged);
  const Sentences reported = judge(judged);
  EXPECT_TRUE(std::any_of(reported.begin(), reported.end(),
                          [&](const auto& one) { return one.find(sentence) != std::string::npos; }))
      << sentence << " is not in: " << testing::PrintToString(reported);
}

JudgeCase flattened(const FlattenInput& input, const Options& options = {}) {
  return {input, options, flatten(input, options)};
}

/// Returns a saddle of 8 by 8 quads with vertices i + 9 j, cut along i = 4 into two pieces in a row. Wire "rigid" runs
/// through both pieces, "elastic" is upright in piece 0, and "other" is in piece 1.
JudgeCase two_sheets() {
  const int n = 8;
  FlattenInput input = test::saddle(n, 0.2);
  test::add_seam(input, test::grid_column(n, n, 4));
  test::add_wire(input, test::grid_row(n, 4), 0, "rigid");
  test::add_wire(input, test::grid_column(n, n, 2), 0.02, "elastic");
  test::add_wire(input, test::grid_column(n, n, 6), 0.02, "other");
  Options options;
  options.layout = PieceLayout::row;
  options.grain = 1;
  return flattened(input, options);
}

/// Sets the error of a piece of two_sheets(). The error names one vertex, and the piece keeps its layout.
void fail(JudgeCase& sheets, ErrorCode code, int number = 0) {
  Piece& piece = sheets.result.pieces.at(number);
  piece.error = FlattenError(code, "The piece cannot be flattened.", {{piece.source_vertex.at(0)}, {}, {}}, true);
}

/// Returns a change of the positions in a piece, which also applies to corner_uv.
Spoil changed(int number, const std::function<void(Piece&)>& change) {
  return [=](JudgeCase& spoiled) {
    Piece& piece = spoiled.result.pieces.at(number);
    change(piece);
    for (const int face : piece.source_face) {
      for (int k = 0; k < 3; ++k) {
        const int v = test::position_in(piece.source_vertex, spoiled.input.faces(face, k));
        spoiled.result.corner_uv.block<1, 2>(face, 2 * k) = piece.vertices.row(v);
      }
    }
  };
}

// right, up: distances in scene units along the axes of the layout. angle: radians.

Spoil moved_vertex(int number, int source_vertex, double right, double up) {
  return changed(number, [=](Piece& piece) {
    piece.vertices.row(test::position_in(piece.source_vertex, source_vertex)) += Eigen::RowVector2d(right, up);
  });
}

Spoil moved(int number, double right, double up) {
  return changed(number, [=](Piece& piece) { piece.vertices.rowwise() += Eigen::RowVector2d(right, up); });
}

Spoil turned(int number, double angle) {
  return changed(number, [=](Piece& piece) {
    piece.vertices = (piece.vertices * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose()).eval();
  });
}

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
  // A strip that runs twice around a cone makes 1.75 turns in the plane. It overlaps itself, unless the method bends
  // it.
  Options unbent = test::by(Method::wirewarping);
  const JudgeCase cone = flattened(test::cone_patch(48, 2, 1, 2, std::asin(7.0 / 8), 4 * kPi), unbent);
  test::expect_error(cone.result.pieces.at(0).error, ErrorCode::overlapping_faces);
  expect_broken("overlap", cone, [](JudgeCase& c) { c.result.pieces[0].error.reset(); });
}

TEST(Judge, ReportsWrongLengths) {
  // Pieces that overlap themselves have exact lengths, too. Their errors must suggest a seam inside the piece.
  const VertexPair inside[2]{{10, 11}, {14, 15}};
  JudgeCase faulty = two_sheets();
  for (const int number : {0, 1}) {
    fail(faulty, ErrorCode::overlapping_faces, number);
    faulty.result.pieces[number].error->elements.proposed_seams = {inside[number]};
  }
  const int corner = 0, on_the_seam = 4, on_rigid = 1 + 9 * 4, on_elastic = 2 + 9 * 2;
  for (const JudgeCase& sheets : {two_sheets(), faulty}) {
    expect_broken("outline 0-", sheets, moved_vertex(0, corner, 1e-6, 1e-6));
    expect_broken("outline 4-", sheets, moved_vertex(1, on_the_seam, 1e-6, 1e-6));
    expect_broken("wire \"rigid\" breaks", sheets, moved_vertex(0, on_rigid, 1e-6, 1e-6));
    expect_broken("wire \"elastic\" breaks", sheets, moved_vertex(0, on_elastic, 1e-6, 1e-6));
  }
  expect_broken("wire \"elastic\" breaks", two_sheets(), [](JudgeCase& c) { c.input.wires.at(1).tolerance = 1e-5; });
}

TEST(Judge, ReportsFailuresThatLegalInputMustNotHave) {
  for (const ErrorCode code : {ErrorCode::not_solvable, ErrorCode::lengths_not_kept}) {
    const std::string sentence = std::string("a piece fails with ") + describe(code).name;
    expect_broken(
        sentence, two_sheets(), [&](JudgeCase& c) { fail(c, code); }, expectations);
  }
  JudgeCase faulty = two_sheets();
  fail(faulty, ErrorCode::zero_area_face);
  expect_broken(
      "legal input has the error zero_area_face", two_sheets(), [&](JudgeCase& c) { c = faulty; }, expectations);
  EXPECT_EQ(test::broken_expectations(faulty.input, faulty.options, faulty.result, ErrorCode::zero_area_face),
            Sentences{})
      << "the fault that was added to the input";
}

TEST(Judge, ReportsPiecesThatUnfoldButAreNotFlat) {
  const JudgeCase patch = flattened(test::cylinder_patch(6, 4, 1, 2, 1));
  expect_broken(
      "a piece that unfolds is distorted", patch, [](JudgeCase& c) { c.result.corner_uv *= 1 + 1e-5; }, expectations);
  expect_broken(
      "a piece that unfolds has the error infeasible_lengths", patch,
      [](JudgeCase& c) { fail(c, ErrorCode::infeasible_lengths); }, expectations);
}

TEST(Judge, ChecksTheLengthsOfAStretchedFabric) {
  const FlattenInput input = two_sheets().input;
  Options options;
  options.cloth.emplace();
  const FlattenResult unstretched = flatten(input, options);
  options.cloth->stretch = {0.2, 0.05};
  const FlattenResult result = flatten(input, options);
  EXPECT_EQ(test::broken_guarantees(input, options, result, &unstretched), Sentences{});
  EXPECT_EQ(test::broken_expectations(input, options, result, std::nullopt, &unstretched), Sentences{});
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
  const auto reported = [&] { return test::broken_expectations(input, options, result, std::nullopt, &unstretched); };
  EXPECT_EQ(reported(), Sentences{});
  result.corner_uv(0, 0) += 1e-3;
  EXPECT_EQ(reported().size(), 1U);
  result.pieces.at(0).error.emplace(ErrorCode::overlapping_faces, "It overlaps itself.");
  EXPECT_EQ(reported().size(), 1U);
}

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
  for (const double angle : {1e-5, kPi}) expect_broken("the grain is not upright", two_sheets(), turned(0, angle));
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
  const JudgeCase trapezoid = flattened(input);
  const std::vector<Piece>& pieces = trapezoid.result.pieces;
  const auto middle =
      std::find_if(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.boundaries.size() == 4; });
  ASSERT_NE(middle, pieces.end());
  const int number = static_cast<int>(middle - pieces.begin());
  expect_broken("the longest chain of the outline is not upright", trapezoid, turned(number, 1e-5));
}

TEST(Judge, ReportsPiecesThatDoNotRise) {
  Options options;
  options.orientation = Orientation::up;
  FlattenInput patch = test::cylinder_patch(6, 4, 1, 2, 1);
  const std::string sentence = "the direction up in space is not up in the piece";
  for (const double angle : {1e-5, kPi}) expect_broken(sentence, flattened(patch, options), turned(0, angle));
  options.orientation = Orientation::grain;
  expect_broken(sentence, flattened(patch, options), turned(0, 1e-5));
  test::add_wire(patch, test::grid_row(6, 2));
  options.grain = 0;
  expect_broken("the grain is not upright", flattened(patch, options), turned(0, 1e-5));
}

TEST(Judge, ReportsChangesByALayout) {
  const JudgeCase sheets = two_sheets();
  const auto reported = [&](const FlattenResult& other) {
    return test::differences_of_layout(sheets.input, sheets.options, sheets.result, other);
  };
  EXPECT_EQ(reported(sheets.result), Sentences{});
  JudgeCase other = sheets;
  turned(0, 1)(other);
  EXPECT_EQ(reported(other.result), Sentences{});
  JudgeCase fewer = sheets;
  fewer.result.pieces.pop_back();
  EXPECT_EQ(reported(fewer.result), Sentences{"the layout changes the number of pieces"});
  JudgeCase failed = sheets;
  fail(failed, ErrorCode::not_solvable);
  EXPECT_EQ(reported(failed.result), Sentences{"the layout changes the outcome of piece 0"});
  JudgeCase longer = sheets;
  longer.result.pieces[1].vertices *= 1 + 1e-12;
  EXPECT_EQ(reported(longer.result), Sentences{"the layout changes lengths"});
}

/// Adds an error to piece 0 of two_sheets(), which says that wires contradict one another, and suggests a tolerance.
/// Spoils this error, and expects that broken_guarantees() reports the sentence.
void expect_wrong_error(const std::string& sentence, const std::function<void(FlattenError&)>& spoil) {
  JudgeCase sheets = two_sheets();
  fail(sheets, ErrorCode::infeasible_lengths);
  sheets.result.pieces[0].error->elements.proposed_tolerances = {{1, 0.05}};
  expect_broken(sentence, sheets, [&](JudgeCase& c) { spoil(*c.result.pieces[0].error); });
}

TEST(Judge, ReportsElementsOfAnotherPiece) {
  const std::string sentence = "names elements of another piece";
  const int other_face = two_sheets().result.pieces.at(1).source_face.at(0);
  expect_wrong_error(sentence, [](FlattenError& e) { e.elements.vertices = {8}; });
  expect_wrong_error(sentence, [](FlattenError& e) { e.elements.edges = {{7, 8}}; });
  expect_wrong_error(sentence, [&](FlattenError& e) { e.elements.faces = {other_face}; });
}

TEST(Judge, ReportsProposalsThatFixNothing) {
  const VertexPair inside{10, 11}, on_the_seam{4, 13};
  const auto propose = [](const std::vector<VertexPair>& seams, const std::vector<ProposedTolerance>& tolerances) {
    return [=](FlattenError& e) {
      e.elements.proposed_seams = seams;
      e.elements.proposed_tolerances = tolerances;
    };
  };
  expect_wrong_error("proposed seam 4-13 does not cut the piece", propose({on_the_seam}, {}));
  expect_wrong_error("a tolerance is proposed for other, which is not in the piece", propose({}, {{2, 0.05}}));
  expect_wrong_error("the tolerance proposed for elastic is not larger than its own", propose({}, {{1, 0.02}}));
  expect_wrong_error("both seams and tolerances are proposed", propose({inside}, {{1, 0.05}}));
  expect_wrong_error("nothing is proposed", propose({}, {}));
}

TEST(Judge, ReportsErrorsThatDoNotFitThePiece) {
  const auto recode = [](ErrorCode code) { return [=](FlattenError& e) { e.code = code; }; };
  expect_wrong_error("wrong topology: closed or open", recode(ErrorCode::closed_chart));
  expect_wrong_error("wrong number of handles", recode(ErrorCode::handles));
  expect_wrong_error("the outline is not too short", recode(ErrorCode::boundary_too_short));
  expect_wrong_error("no seam is proposed", recode(ErrorCode::boundary_too_short));
  expect_wrong_error("no seam is proposed", recode(ErrorCode::overlapping_faces));
  expect_wrong_error("tolerances cannot fix this error", recode(ErrorCode::overlapping_faces));
  expect_wrong_error("has_layout is wrong", [](FlattenError& e) { e.has_layout = false; });
  const int own_face = two_sheets().result.pieces.at(0).source_face.at(0);
  expect_wrong_error("is reported as flipped", [&](FlattenError& e) {
    e.code = ErrorCode::flipped_faces;
    e.elements.faces = {own_face};
  });
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
  const std::string message = "The wires contradict one another.";
  EXPECT_EQ(reported(message, {{0}, {}, {}}), Sentences{});
  for (const char* bad : {"", "No.", "The wires contradict one another"}) {
    EXPECT_EQ(reported(bad, {{0}, {}, {}}), Sentences{std::string("infeasible_lengths has no sentence: ") + bad});
  }
  EXPECT_EQ(reported(message, {}), Sentences{"infeasible_lengths names no element: " + message});
  for (const ErrorElements& elements : std::vector<ErrorElements>{{{9}, {}, {}},
                                                                  {{-1}, {}, {}},
                                                                  {{}, {{0, 9}}, {}},
                                                                  {{}, {}, {8}},
                                                                  {{}, {}, {-1}},
                                                                  {{0}, {}, {}, {{9, 0}}},
                                                                  {{0}, {}, {}, {}, {{0, 0.1}}}}) {
    EXPECT_EQ(reported(message, elements), Sentences{"infeasible_lengths names elements that the input does not have"});
  }
}

constexpr int kSeeds = 20;  // number of seeds in each test, so that several tests can run at once

class RandomCases : public testing::TestWithParam<int> {};

TEST_P(RandomCases, KeepEveryGuarantee) {
  for (int seed = kSeeds * GetParam(); seed < kSeeds * (GetParam() + 1); ++seed) {
    const test::RandomCase random_case = test::make_random_case(static_cast<std::uint64_t>(seed));
    const test::Outcome outcome = test::judge(random_case);
    EXPECT_EQ(outcome.broken, std::vector<std::string>{}) << "seed " << seed << ": " << random_case.description;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCases, testing::Range(0, 20));

}  // namespace
}  // namespace wirewarp::test_judge
