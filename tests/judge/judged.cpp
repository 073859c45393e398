// SPDX-License-Identifier: GPL-3.0-or-later
#include "judged.h"

namespace wirewarp::test {

Judged::Judged(const FlattenInput& the_input, const Options& the_options, const FlattenResult& the_result,
               const FlattenResult* the_unstretched)
    : input(the_input),
      options(the_options),
      result(the_result),
      unstretched(the_unstretched),
      piece_of_(input.faces.rows(), -1) {
  for (int f = 0; f < input.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) sides_[edge(f, k)].push_back({f, k});
  }
  for (int i = 0; i < input.seams.rows(); ++i) seams_.insert(edge_of(input.seams(i, 0), input.seams(i, 1)));
  for (const auto& [edge, of_edge] : sides_) {
    if (is_outline(edge)) outline_vertices_.insert(edge.begin(), edge.end());
  }
  for (std::size_t p = 0; p < result.pieces.size(); ++p) {
    for (const int face : result.pieces[p].source_face) {
      int& owner = piece_of_[face];
      if (owner >= 0) say("face " + std::to_string(face) + " is in two pieces");
      owner = static_cast<int>(p);
    }
  }
  if (std::count(piece_of_.begin(), piece_of_.end(), -1) > 0) say("a face is in no piece");
}

double Judged::uv_size(const Piece& piece) const {
  double size = 0;
  for (const int face : piece.source_face) {
    for (int k = 0; k < 6; ++k) {
      const double value = std::abs(result.corner_uv(face, k));
      if (std::isnan(value)) return value;
      size = std::max(size, value);
    }
  }
  return size;
}

std::vector<Side> Judged::sides_in(const Edge& edge, int piece) const {
  std::vector<Side> found;
  const auto of_edge = sides_.find(edge);
  if (of_edge == sides_.end()) return found;
  for (const Side& side : of_edge->second) {
    if (piece_of(side.face) == piece) found.push_back(side);
  }
  return found;
}

std::vector<std::array<int, 2>> Judged::outline_of(const Piece& piece) const {
  std::vector<std::array<int, 2>> outline;
  for (const auto& corners : piece.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      const int a = corners[k], b = corners[(k + 1) % 3];
      if (is_outline(edge_of(piece.source_vertex[a], piece.source_vertex[b]))) outline.push_back({a, b});
    }
  }
  return outline;
}

}  // namespace wirewarp::test
