// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_lengths.h"

#include <limits>

namespace wirewarp::test {
namespace {

constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

struct EdgeLengths {
  double in_space;
  double planar;
  double rounding;
};

bool is_all_rigid(const Options& options) {
  if (options.method == Method::refined) return false;
  return options.method == Method::wirewarping || options.inner == Inner::least_norm;
}

/// The edges of a wire that lie inside pieces without an error, part by part. Parts end on seams and borders, and where
/// pieces touch.
std::vector<std::vector<EdgeLengths>> parts_of(const Judged& judged, const Wire& wire) {
  std::vector<std::vector<EdgeLengths>> parts(1);
  const auto piece_at = [&](std::size_t i) {
    return judged.piece_of(judged.sides().at(edge_of(wire.vertices[i], wire.vertices[i + 1])).front().face);
  };
  const std::size_t last = wire.vertices.size() - 2;
  const auto begins_part = [&](std::size_t i) {
    return judged.is_outline_vertex(wire.vertices[i]) || piece_at(i) != piece_at(i > 0 ? i - 1 : last);
  };
  for (std::size_t i = 0; i <= last; ++i) {
    if (i > 0 && begins_part(i)) parts.emplace_back();
    const Edge edge = edge_of(wire.vertices[i], wire.vertices[i + 1]);
    const Side side = judged.sides().at(edge).front();
    const Piece& piece = judged.result.pieces[piece_at(i)];
    if (judged.is_outline(edge) || piece.error) continue;  // outlines are checked; failed pieces promise nothing
    parts.back().push_back({judged.length_3d(edge), judged.length_2d(side), kRounding * judged.uv_size(piece)});
  }
  const bool goes_on = wire.vertices.front() == wire.vertices.back() && !begins_part(0);
  if (goes_on && parts.size() > 1) {  // across the wire's begin
    parts.front().insert(parts.front().end(), parts.back().begin(), parts.back().end());
    parts.pop_back();
  }
  return parts;
}

/// All edges of a part have planar lengths (1+h) l for one h: the intervals of h that they leave must meet.
void check_part(Judged& judged, const Wire& wire, double tolerance, const std::vector<EdgeLengths>& edges) {
  double low = wire.ease - tolerance;
  double high = wire.ease + tolerance;
  for (const EdgeLengths& edge : edges) {
    const double slack = 1.0001e-9 + edge.rounding / edge.in_space;
    low = std::max(low, edge.planar / edge.in_space - 1 - slack);
    high = std::min(high, edge.planar / edge.in_space - 1 + slack);
  }
  if (low > high) judged.say("wire \"" + wire.name + "\" breaks its tolerance by " + std::to_string(low - high));
}

const Wire* wire_along(const FlattenInput& input, const Edge& edge) {
  for (const Wire& wire : input.wires) {
    for (std::size_t i = 0; i + 1 < wire.vertices.size(); ++i) {
      if (edge_of(wire.vertices[i], wire.vertices[i + 1]) == edge) return &wire;
    }
  }
  return nullptr;
}

/// r of a side.
double ease_of(const Judged& judged, const Side& side) {
  const int from = judged.vertex(side.face, side.corner), to = judged.vertex(side.face, side.corner + 1);
  for (const Ease& ease : judged.input.eases) {
    for (const auto& ends : ease.half_edges.rowwise()) {
      if (ends[0] == from && ends[1] == to) return ease.ratio;
    }
  }
  return 0;
}

/// All sides of an outline edge in good pieces have planar lengths (1+r)(1+h) l for one h.
void check_outline_edge(Judged& judged, const Edge& edge) {
  const Wire* wire = wire_along(judged.input, edge);
  const Wire none;
  std::vector<EdgeLengths> sides;
  for (const Side& side : judged.sides().at(edge)) {
    const Piece& piece = judged.result.pieces[judged.piece_of(side.face)];
    const double eased = 1 + ease_of(judged, side);
    if (piece.error) continue;
    sides.push_back({judged.length_3d(edge), judged.length_2d(side) / eased,
                     kRounding * judged.uv_size(piece) / std::min(eased, 1.0)});
  }
  const double tolerance = !wire || is_all_rigid(judged.options) ? 0 : wire->tolerance;
  const std::size_t num_before = judged.num_sentences();
  check_part(judged, wire ? *wire : none, tolerance, sides);
  if (judged.num_sentences() > num_before) judged.say("outline " + name(edge) + " is off");
}

}  // namespace

void check_outline(Judged& judged, const Piece& piece) {
  for (const int face : piece.source_face) {
    for (int k = 0; k < 3; ++k) {
      const Edge edge = edge_of(judged.vertex(face, k), judged.vertex(face, k + 1));
      if (judged.is_outline(edge)) {
        check_outline_edge(judged, edge);
        continue;
      }
      for (const Side& other : judged.sides().at(edge)) {  // the same ends from both sides
        const bool turned = judged.vertex(other.face, other.corner) != judged.vertex(face, k);
        const Eigen::Vector2d begin = judged.uv(other.face, other.corner + (turned ? 1 : 0));
        if (begin != judged.uv(face, k)) judged.say("torn at " + name(edge));
      }
    }
  }
}

void check_wires(Judged& judged) {
  for (const Wire& wire : judged.input.wires) {
    const double tolerance = is_all_rigid(judged.options) ? 0 : wire.tolerance;
    if (std::isinf(tolerance)) continue;
    for (const auto& part : parts_of(judged, wire)) check_part(judged, wire, tolerance, part);
  }
}

}  // namespace wirewarp::test
