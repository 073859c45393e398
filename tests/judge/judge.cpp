// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.h"

#include <algorithm>
#include <regex>

#include "checks.h"

namespace wirewarp::test {
namespace {

/// Checks that a piece and corner_uv have the same coordinates.
void check_corners(Judged& judged, const Piece& piece) {
  if (static_cast<Eigen::Index>(piece.source_face.size()) != piece.faces.rows()) {
    return judged.say("source_face has wrong size");
  }
  for (std::size_t f = 0; f < piece.source_face.size(); ++f) {
    const int face = piece.source_face[f];
    for (int k = 0; k < 3; ++k) {
      const int corner = piece.faces(f, k);
      bool found = false;  // the piece may start the face at another corner
      for (int c = 0; c < 3; ++c) {
        found = found || (piece.source_vertex[corner] == judged.vertex(face, c) &&
                          piece.vertices.row(corner) == judged.uv(face, c).transpose());
      }
      if (!found) judged.say("piece and corner_uv differ at face " + std::to_string(face));
    }
  }
}

void check_shape(Judged& judged, const Piece& piece) {
  std::vector<PlanarTriangle> triangles;
  for (const int face : piece.source_face) {
    triangles.push_back(judged.triangle(face));
    if (!(doubled_area(triangles.back()) > 0)) judged.say("face " + std::to_string(face) + " is flipped");
  }
  const auto [first, second] = find_overlap(triangles);
  if (first < 0) return;
  judged.say("faces " + std::to_string(piece.source_face[first]) + " and " + std::to_string(piece.source_face[second]) +
             " overlap");
}

void check_piece(Judged& judged, int number) {
  const Piece& piece = judged.result.pieces[number];
  // With a fabric, Options::orientation only chooses a direction between two vertices, and the stretch turns all
  // directions except weft and warp. So the direction of the result is not checked.
  if (judged.has_layout(piece) && !judged.options.cloth) check_orientation(judged, number);
  if (piece.error) {
    check_error(judged, number);
    if (judged.has_layout(piece) && keeps_lengths(piece)) check_outline(judged, piece);
    return;
  }
  if (!std::isfinite(judged.uv_size(piece))) {
    return judged.say("piece " + std::to_string(number) + " has no error and no coordinates");
  }
  check_corners(judged, piece);
  check_outline(judged, piece);
  check_shape(judged, piece);
}

}  // namespace

Sentences broken_guarantees(const FlattenInput& input, const Options& options, const FlattenResult& result,
                            const FlattenResult* unstretched) {
  Judged judged(input, options, result, unstretched);
  for (int p = 0; p < static_cast<int>(result.pieces.size()); ++p) check_piece(judged, p);
  check_room(judged);
  check_wires(judged);
  return judged.take_sentences();
}

Sentences broken_expectations(const FlattenInput& input, const Options& options, const FlattenResult& result,
                              const std::optional<ErrorCode>& fault, const FlattenResult* unstretched) {
  Judged judged(input, options, result, unstretched);
  for (const Piece& piece : result.pieces) {
    const std::string name = piece.error ? describe(piece.error->code).name : "";
    const bool is_of_fault = piece.error && (piece.error->code == fault);
    if (!is_of_fault && piece.error && is_of_mesh(piece.error->code)) judged.say("legal input has the error " + name);
    if (piece.error && is_of_mesh(piece.error->code)) continue;
    check_unfolding(judged, piece);
    check_even_stretch(judged, piece);
    if (piece.error &&
        (piece.error->code == ErrorCode::not_solvable || piece.error->code == ErrorCode::lengths_not_kept)) {
      judged.say("a piece fails with " + name + ": " + piece.error->what());
    }
  }
  return judged.take_sentences();
}

Sentences differences_of_layout(const FlattenInput& input, const Options& options, const FlattenResult& result,
                                const FlattenResult& other) {
  Judged judged(input, options, result);
  check_same_shapes(judged, other);
  return judged.take_sentences();
}

Sentences faults_of_error(const FlattenError& error, const FlattenInput& input) {
  Sentences faults;
  const std::string name = describe(error.code).name;
  const std::string sentence = error.what();
  if (sentence.size() < 20 || sentence.back() != '.') faults.push_back(name + " has no sentence: " + sentence);
  for (const auto& [argument, value] : error.arguments) {
    const std::regex whole_word("\\b" + argument + "\\b");  // names of arguments have no special characters
    const std::string documented = describe(error.code).arguments;
    if (!std::regex_search(documented, whole_word)) faults.push_back("undocumented argument: " + argument);
  }
  const ErrorElements& named = error.elements;
  const std::set<ErrorCode> of_no_element{ErrorCode::empty_mesh, ErrorCode::invalid_option, ErrorCode::wire_too_short,
                                          ErrorCode::cancelled};
  if (!of_no_element.count(error.code) && named.vertices.empty() && named.edges.empty() && named.faces.empty()) {
    faults.push_back(name + " names no element: " + sentence);
  }
  if (error.code == ErrorCode::vertex_out_of_range) return faults;  // this error names a vertex that does not exist
  const auto is_vertex = [&](int v) { return v >= 0 && v < input.vertices.rows(); };
  bool all_there = std::all_of(named.vertices.begin(), named.vertices.end(), is_vertex);
  for (const auto* pairs : {&named.edges, &named.proposed_seams}) {
    for (const VertexPair& pair : *pairs) all_there = all_there && is_vertex(pair[0]) && is_vertex(pair[1]);
  }
  for (const int face : named.faces) all_there = all_there && face >= 0 && face < input.faces.rows();
  for (const ProposedTolerance& proposed : named.proposed_tolerances) {
    all_there = all_there && proposed.wire >= 0 && proposed.wire < static_cast<int>(input.wires.size());
  }
  if (!all_there) faults.push_back(name + " names elements that the input does not have");
  return faults;
}

}  // namespace wirewarp::test
