// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "planar_overlap.h"

namespace wirewarp::test {
namespace {

using Edge = VertexPair;  // the smaller vertex first
using Sentences = std::vector<std::string>;

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// One side of an edge: the face, and the corner at which it begins.
struct Side {
  int face;
  int corner;
};

using Sides = std::map<Edge, std::vector<Side>>;

class Judge {
 public:
  Judge(const FlattenInput& input, const Options& options, const FlattenResult& result)
      : input_(input), mirror_(options.mirror), all_rigid_(is_all_rigid(options)), result_(result) {
    for (int f = 0; f < input_.faces.rows(); ++f) {
      for (int k = 0; k < 3; ++k) sides_[edge_of(vertex(f, k), vertex(f, k + 1))].push_back({f, k});
    }
    for (int i = 0; i < input_.seams.rows(); ++i) seams_.insert(edge_of(input_.seams(i, 0), input_.seams(i, 1)));
  }

  Sentences broken() {
    check_pieces();
    check_room();
    for (std::size_t p = 0; p < result_.pieces.size(); ++p) {
      const Piece& piece = result_.pieces[p];
      if (piece.error) {
        for (std::string& fault : faults_of_error(*piece.error, input_)) say(std::move(fault));
        if (!piece.error->has_layout && uv_size(piece) == uv_size(piece)) say("a piece without layout has coordinates");
        continue;
      }
      check_outline(piece, static_cast<int>(p));
      check_shape(piece);
    }
    check_wires();
    return std::move(sentences_);
  }

 private:
  static bool is_all_rigid(const Options& options) {
    if (options.method == Method::refined) return false;
    return options.method == Method::wirewarping || options.inner == Inner::least_norm;
  }

  void say(std::string sentence) {
    if (sentences_.size() < 10) sentences_.push_back(std::move(sentence));
  }

  int vertex(int face, int corner) const { return input_.faces(face, corner % 3); }

  Eigen::Vector2d uv(int face, int corner) const {
    return result_.corner_uv.block<1, 2>(face, 2 * (corner % 3)).transpose();
  }

  /// max |uv| of a piece, NaN without a layout.
  double uv_size(const Piece& piece) const {
    double size = 0;
    for (const int face : piece.source_face) {
      for (int k = 0; k < 6; ++k) {
        const double value = std::abs(result_.corner_uv(face, k));
        if (!(value <= size)) size = value;
        if (std::isnan(value)) return value;
      }
    }
    return size;
  }

  bool is_outline(const Edge& edge) const { return seams_.count(edge) || sides_.at(edge).size() == 1; }

  double length_3d(const Edge& edge) const {
    return (input_.vertices.row(edge[0]) - input_.vertices.row(edge[1])).norm();
  }

  double length_2d(const Side& side) const {
    return (uv(side.face, side.corner) - uv(side.face, side.corner + 1)).norm();
  }

  /// Every face is in one piece; pieces and corners tell the same coordinates.
  void check_pieces() {
    std::vector<int> owner(static_cast<std::size_t>(input_.faces.rows()), -1);
    for (std::size_t p = 0; p < result_.pieces.size(); ++p) {
      const Piece& piece = result_.pieces[p];
      if (static_cast<Eigen::Index>(piece.source_face.size()) != piece.faces.rows()) say("source_face has wrong size");
      for (std::size_t f = 0; f < piece.source_face.size(); ++f) {
        const int face = piece.source_face[f];
        if (owner[static_cast<std::size_t>(face)] >= 0) say("face " + std::to_string(face) + " is in two pieces");
        owner[static_cast<std::size_t>(face)] = static_cast<int>(p);
        for (int k = 0; k < 3 && !piece.error; ++k) {
          const int corner = piece.faces(static_cast<Eigen::Index>(f), k);
          bool found = false;  // the piece may begin the face at another corner
          for (int c = 0; c < 3; ++c) {
            found = found || (piece.source_vertex[static_cast<std::size_t>(corner)] == vertex(face, c) &&
                              piece.vertices.row(corner) == uv(face, c).transpose());
          }
          if (!found) say("piece and corner_uv differ at face " + std::to_string(face));
        }
      }
    }
    if (std::count(owner.begin(), owner.end(), -1) > 0) say("a face is in no piece");
  }

  /// Pieces do not touch: their boxes lie apart.
  void check_room() {
    std::vector<std::array<double, 4>> boxes;  // left, bottom, right, top
    for (const Piece& piece : result_.pieces) {
      if (!(uv_size(piece) >= 0)) continue;
      std::array<double, 4> box{1e300, 1e300, -1e300, -1e300};
      for (const int face : piece.source_face) {
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector2d at = uv(face, k);
          box = {std::min(box[0], at.x()), std::min(box[1], at.y()), std::max(box[2], at.x()),
                 std::max(box[3], at.y())};
        }
      }
      for (const auto& other : boxes) {
        const double across = std::min(box[2], other[2]) - std::max(box[0], other[0]);
        const double up = std::min(box[3], other[3]) - std::max(box[1], other[1]);
        const double rounding = 1e-9 * std::max({std::abs(box[2]), std::abs(box[3]), other[2], other[3]});
        if (across > rounding && up > rounding) say("pieces lie over each other");
      }
      boxes.push_back(box);
    }
  }

  /// Outline edges are exact, inner edges are not torn.
  void check_outline(const Piece& piece, int number) {
    const double size = uv_size(piece);
    if (!std::isfinite(size)) {
      say("piece " + std::to_string(number) + " has no error and no coordinates");
      return;
    }
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * size;
    for (const int face : piece.source_face) {
      for (int k = 0; k < 3; ++k) {
        const Edge edge = edge_of(vertex(face, k), vertex(face, k + 1));
        const Side side{face, k};
        if (is_outline(edge)) {
          const double wrong = std::abs(length_2d(side) - length_3d(edge)) - rounding;
          if (wrong > 1.0001e-9 * length_3d(edge)) say("outline " + name(edge) + " is off by " + std::to_string(wrong));
          continue;
        }
        for (const Side& other : sides_.at(edge)) {  // the same ends from both sides
          const bool turned = vertex(other.face, other.corner) != vertex(face, k);
          const Eigen::Vector2d begin = uv(other.face, other.corner + (turned ? 1 : 0));
          if (begin != uv(face, k)) say("torn at " + name(edge));
        }
      }
    }
  }

  void check_shape(const Piece& piece) {
    std::vector<PlanarTriangle> triangles;
    for (const int face : piece.source_face) {
      PlanarTriangle triangle{uv(face, 0), uv(face, 1), uv(face, 2)};
      if (mirror_) std::swap(triangle[1], triangle[2]);
      if (!(doubled_area(triangle) > 0)) say("face " + std::to_string(face) + " is turned over");
      triangles.push_back(triangle);
    }
    const auto [first, second] = find_overlap(triangles);
    if (first < 0) return;
    say("faces " + std::to_string(piece.source_face[static_cast<std::size_t>(first)]) + " and " +
        std::to_string(piece.source_face[static_cast<std::size_t>(second)]) + " overlap");
  }

  /// Rigid wires are exact; the edges of each part of an elastic one change alike, within its tolerance.
  void check_wires() {
    std::vector<int> piece_of(static_cast<std::size_t>(input_.faces.rows()), -1);
    for (std::size_t p = 0; p < result_.pieces.size(); ++p) {
      for (const int face : result_.pieces[p].source_face) {
        piece_of[static_cast<std::size_t>(face)] = result_.pieces[p].error ? -1 : static_cast<int>(p);
      }
    }
    std::set<int> cut;  // vertices on seams and borders: wires are cut into parts there
    for (const auto& [edge, sides] : sides_) {
      if (is_outline(edge)) cut.insert(edge.begin(), edge.end());
    }
    for (const Wire& wire : input_.wires) {
      const double tolerance = all_rigid_ ? 0 : wire.tolerance;
      if (std::isinf(tolerance)) continue;
      const bool closed = wire.vertices.front() == wire.vertices.back();
      std::vector<std::array<double, 3>> part;  // length, its planar length, rounding
      std::vector<std::array<double, 3>> first_part;
      bool is_first = true;
      for (std::size_t i = 0; i + 1 < wire.vertices.size(); ++i) {
        const Edge edge = edge_of(wire.vertices[i], wire.vertices[i + 1]);
        const Side side = sides_.at(edge).front();
        const int piece = piece_of[static_cast<std::size_t>(side.face)];
        if (cut.count(wire.vertices[i]) && i > 0) {
          (is_first && closed ? first_part : part) = part;
          if (!is_first || !closed) check_part(wire, tolerance, part);
          is_first = false;
          part.clear();
        }
        if (is_outline(edge) || piece < 0) continue;  // outlines are checked; failed pieces promise nothing
        const double rounding =
            8 * std::numeric_limits<double>::epsilon() * uv_size(result_.pieces[static_cast<std::size_t>(piece)]);
        part.push_back({length_3d(edge), length_2d(side), rounding});
      }
      if (closed && !is_first && !cut.count(wire.vertices.front())) {
        part.insert(part.end(), first_part.begin(), first_part.end());  // it goes on across the wire's begin
      } else if (!first_part.empty()) {
        check_part(wire, tolerance, first_part);
      }
      check_part(wire, tolerance, part);
    }
  }

  void check_part(const Wire& wire, double tolerance, const std::vector<std::array<double, 3>>& edges) {
    // All edges of a part have planar lengths (1+h) l for one h: the intervals of h that they leave must meet.
    double low = -tolerance;
    double high = tolerance;
    for (const auto& [length, planar, rounding] : edges) {
      const double slack = 1.0001e-9 + rounding / length;
      low = std::max(low, planar / length - 1 - slack);
      high = std::min(high, planar / length - 1 + slack);
    }
    if (low > high) say("wire \"" + wire.name + "\" breaks its tolerance by " + std::to_string(low - high));
  }

  static std::string name(const Edge& edge) { return std::to_string(edge[0]) + "-" + std::to_string(edge[1]); }

  const FlattenInput& input_;
  bool mirror_;
  bool all_rigid_;
  const FlattenResult& result_;
  Sides sides_;
  std::set<Edge> seams_;
  Sentences sentences_;
};

}  // namespace

Sentences broken_promises(const FlattenInput& input, const Options& options, const FlattenResult& result) {
  return Judge(input, options, result).broken();
}

Sentences faults_of_error(const FlattenError& error, const FlattenInput& input) {
  Sentences faults;
  const std::string name = describe(error.code).name;
  const std::string sentence = error.what();
  if (sentence.size() < 20 || sentence.back() != '.') faults.push_back(name + " has no sentence: " + sentence);
  const ErrorElements& named = error.elements;
  const std::set<ErrorCode> of_no_element{ErrorCode::empty_mesh, ErrorCode::invalid_option, ErrorCode::wire_too_short};
  if (!of_no_element.count(error.code) && named.vertices.empty() && named.edges.empty() && named.faces.empty()) {
    faults.push_back(name + " names no element: " + sentence);
  }
  if (error.code == ErrorCode::vertex_out_of_range) return faults;  // names what is not there
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
