// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "planar_overlap.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

using Edge = VertexPair;  // the smaller vertex first
using Sentences = std::vector<std::string>;

inline Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

inline std::string name(const Edge& edge) { return std::to_string(edge[0]) + "-" + std::to_string(edge[1]); }

inline std::vector<Edge> edges_of(const Wire& wire) {
  std::vector<Edge> edges;
  for (std::size_t i = 1; i < wire.vertices.size(); ++i) {
    edges.push_back(edge_of(wire.vertices[i - 1], wire.vertices[i]));
  }
  return edges;
}

/// One side of an edge: the face on this side, and the corner of the face at which the side starts.
struct Side {
  int face;
  int corner;
};

/// An input and its result, with lookups for the judge and a list of broken guarantees.
class Judged {
 public:
  /// unstretched: the result without the stretch if the fabric is stretched when worn, otherwise null.
  Judged(const FlattenInput& input, const Options& options, const FlattenResult& result,
         const FlattenResult* unstretched = nullptr);

  /// Adds a sentence about a broken guarantee. Keeps only the first ten sentences.
  void say(std::string sentence) {
    if (sentences_.size() < 10) sentences_.push_back(std::move(sentence));
  }
  Sentences take_sentences() { return std::move(sentences_); }

  int vertex(int face, int corner) const { return input.faces(face, corner % 3); }
  Edge edge(int face, int corner) const { return edge_of(vertex(face, corner), vertex(face, corner + 1)); }
  Eigen::Vector3d position(int vertex) const { return input.vertices.row(vertex).transpose(); }
  Eigen::Vector2d uv(int face, int corner) const {
    return result.corner_uv.block<1, 2>(face, 2 * (corner % 3)).transpose();
  }
  /// Returns a face in the plane. The triangle is counter-clockwise if the face is not flipped.
  PlanarTriangle triangle(int face) const {
    const bool turned = options.mirror;
    return {uv(face, 0), uv(face, turned ? 2 : 1), uv(face, turned ? 1 : 2)};
  }

  /// Returns the largest |u| or |v| of a piece, or NaN if the piece has no layout.
  double uv_size(const Piece& piece) const;
  bool has_layout(const Piece& piece) const { return !std::isnan(uv_size(piece)); }

  /// Returns whether the limit on factorizations is so low that the refined method may stop before it converges.
  bool may_stop_anywhere() const { return options.max_factorizations < 20; }

  const std::map<Edge, std::vector<Side>>& sides() const { return sides_; }
  bool is_outline(const Edge& edge) const { return seams_.count(edge) || sides_.at(edge).size() == 1; }
  bool is_outline_vertex(int vertex) const { return outline_vertices_.count(vertex) > 0; }
  int num_outline_edges(int vertex) const { return static_cast<int>(outline_vertices_.count(vertex)); }

  std::vector<Side> sides_in(const Edge& edge, int piece) const;
  int piece_of(int face) const { return piece_of_[face]; }

  /// Returns the edges of a piece's outline as pairs of piece vertices, with the piece on the left.
  std::vector<std::array<int, 2>> outline_of(const Piece& piece) const;

  double length_3d(const Edge& edge) const { return (position(edge[0]) - position(edge[1])).norm(); }
  double length_2d(const Side& side) const {
    return (uv(side.face, side.corner) - uv(side.face, side.corner + 1)).norm();
  }

  const FlattenInput& input;
  const Options& options;
  const FlattenResult& result;
  const FlattenResult* const unstretched;

 private:
  std::map<Edge, std::vector<Side>> sides_;
  std::set<Edge> seams_;
  std::multiset<int> outline_vertices_;  // one entry for each outline edge at the vertex
  std::vector<int> piece_of_;
  Sentences sentences_;
};

}  // namespace wirewarp::test
