// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_case.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "judge.h"
#include "test_meshes.h"

namespace wirewarp::test {
namespace {

using Sentences = std::vector<std::string>;

Sentences guarantees(const JudgeCase& judged) { return broken_guarantees(judged.input, judged.options, judged.result); }

Sentences expectations(const JudgeCase& judged) {
  return broken_expectations(judged.input, judged.options, judged.result, std::nullopt);
}

void expect_reported(Sentences (*judge)(const JudgeCase&), const std::string& sentence, JudgeCase judged,
                     const Spoil& spoil) {
  EXPECT_EQ(judge(judged), Sentences{}) << "before it is spoiled";
  spoil(judged);
  const Sentences reported = judge(judged);
  const bool is_reported = std::any_of(reported.begin(), reported.end(),
                                       [&](const auto& one) { return one.find(sentence) != std::string::npos; });
  EXPECT_TRUE(is_reported) << sentence << " is not in: " << ::testing::PrintToString(reported);
}

/// Copies the piece's coordinates to its faces' corners in corner_uv.
void write_corners(JudgeCase& spoiled, const Piece& piece) {
  for (std::size_t f = 0; f < piece.source_face.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int corner = piece.faces(static_cast<Eigen::Index>(f), k);
      for (int c = 0; c < 3; ++c) {
        if (spoiled.input.faces(piece.source_face[f], c) != piece.source_vertex[corner]) continue;
        spoiled.result.corner_uv.block<1, 2>(piece.source_face[f], 2 * c) = piece.vertices.row(corner);
      }
    }
  }
}

}  // namespace

JudgeCase flattened(const FlattenInput& input, const Options& options) {
  return {input, options, flatten(input, options)};
}

JudgeCase two_sheets() {
  const int n = 8;
  FlattenInput input = saddle(n, 0.2);
  add_seam(input, grid_column(n, n, 4));
  add_wire(input, grid_row(n, 4), 0, "rigid");
  add_wire(input, grid_column(n, n, 2), 0.02, "elastic");
  add_wire(input, grid_column(n, n, 6), 0.02, "other");
  Options options;
  options.layout = PieceLayout::row;
  options.grain = 1;
  return flattened(input, options);
}

void expect_broken(const std::string& sentence, JudgeCase good, const Spoil& spoil) {
  expect_reported(guarantees, sentence, std::move(good), spoil);
}

void expect_broken_expectation(const std::string& sentence, JudgeCase good, const Spoil& spoil) {
  expect_reported(expectations, sentence, std::move(good), spoil);
}

Spoil moved_vertex(int number, int source_vertex, double right, double up) {
  return [=](JudgeCase& spoiled) {
    Piece& piece = spoiled.result.pieces.at(number);
    const auto found = std::find(piece.source_vertex.begin(), piece.source_vertex.end(), source_vertex);
    ASSERT_NE(found, piece.source_vertex.end());
    piece.vertices.row(found - piece.source_vertex.begin()) += Eigen::RowVector2d(right, up);
    write_corners(spoiled, piece);
  };
}

Spoil moved(int number, double right, double up) {
  return [=](JudgeCase& spoiled) {
    Piece& piece = spoiled.result.pieces.at(number);
    piece.vertices.rowwise() += Eigen::RowVector2d(right, up);
    write_corners(spoiled, piece);
  };
}

Spoil turned(int number, double angle) {
  return [=](JudgeCase& spoiled) {
    Piece& piece = spoiled.result.pieces.at(number);
    piece.vertices = (piece.vertices * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose()).eval();
    write_corners(spoiled, piece);
  };
}

void fail(JudgeCase& sheets, ErrorCode code, int number) {
  Piece& piece = sheets.result.pieces.at(number);
  piece.error = FlattenError(code, "The piece cannot be flattened.", {{piece.source_vertex.at(0)}, {}, {}}, true);
}

}  // namespace wirewarp::test
