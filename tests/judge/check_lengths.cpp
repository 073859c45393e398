// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <set>

#include "checks.h"

namespace wirewarp::test {
namespace {

constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

struct EdgeLengths {
  double target;  // target length, without the variation h and the ease r
  double planar;
  double slack;  // allowed error of the planar length
};

/// Returns the lengths of one side of an edge. The planar length and its slack are divided by 1 + ease. is_stretched:
/// whether a fabric that is stretched when worn shortens the target.
EdgeLengths lengths_of(const Judged& judged, const Edge& edge, const Side& side, double ease, bool is_stretched) {
  const double in_space = judged.length_3d(edge);
  const int piece = judged.piece_of(side.face);
  double rounding = kRounding * judged.uv_size(judged.result.pieces[piece]);
  double share = 1;
  if (is_stretched && judged.unstretched) {
    share = stretched_share(judged, edge);
    // The share depends on the edge's direction in the result without the stretch, whose rounding errors count, too.
    rounding += kRounding * judged.uv_size(judged.unstretched->pieces[piece]);
  }
  const double slack = 1.0001e-9 * in_space + rounding;
  return {share * in_space, judged.length_2d(side) / (1 + ease), slack / (1 + ease)};
}

bool is_all_rigid(const Options& options) {
  if (options.method == Method::refined) return false;
  return options.method == Method::wirewarping || options.inner == Inner::least_norm;
}

/// Returns the lengths of the edges of each part of a wire. Lists only edges inside pieces that keep their lengths.
/// Parts end at outlines, and where the wire enters another piece.
std::vector<std::vector<EdgeLengths>> parts_of(const Judged& judged, const Wire& wire) {
  std::vector<std::vector<EdgeLengths>> parts(1);
  const std::vector<Edge> edges = edges_of(wire);
  const std::size_t last = edges.size() - 1;
  const auto piece_at = [&](std::size_t i) { return judged.piece_of(judged.sides().at(edges[i]).front().face); };
  const auto begins_part = [&](std::size_t i) {
    return judged.is_outline_vertex(wire.vertices[i]) || piece_at(i) != piece_at(i > 0 ? i - 1 : last);
  };
  for (std::size_t i = 0; i <= last; ++i) {
    if (i > 0 && begins_part(i)) parts.emplace_back();
    if (judged.is_outline(edges[i])) continue;  // check_run() checks outlines
    if (!keeps_lengths(judged.result.pieces[piece_at(i)])) continue;
    parts.back().push_back(lengths_of(judged, edges[i], judged.sides().at(edges[i]).front(), 0, wire.ease == 0));
  }
  const bool goes_on = wire.vertices.front() == wire.vertices.back() && !begins_part(0);
  if (goes_on && parts.size() > 1) {  // one part continues across the wire's first vertex
    parts.front().insert(parts.front().end(), parts.back().begin(), parts.back().end());
    parts.pop_back();
  }
  return parts;
}

/// The range of the variation h for which all edges passed to meet() have planar lengths of 1 + h times their target.
struct Variations {
  double low, high;

  /// Begins with the range from ease - tolerance to ease + tolerance. tolerance: 0 for a rigid wire.
  explicit Variations(double tolerance, double ease = 0) : low(ease - tolerance), high(ease + tolerance) {}

  void meet(const EdgeLengths& edge) {
    low = std::max(low, (edge.planar - edge.slack) / edge.target - 1);
    high = std::min(high, (edge.planar + edge.slack) / edge.target - 1);
  }

  /// Returns the distance between the bounds if no h fits, and 0 or less if some h fits.
  double gap() const { return low - high; }
};

void check_part(Judged& judged, const Wire& wire, double tolerance, const std::vector<EdgeLengths>& edges) {
  Variations variations(tolerance, wire.ease);
  for (const EdgeLengths& edge : edges) variations.meet(edge);
  if (variations.gap() > 0) {
    judged.say("wire \"" + wire.name + "\" breaks its tolerance by " + std::to_string(variations.gap()));
  }
}

double ease_of(const Judged& judged, const Side& side) {
  const int from = judged.vertex(side.face, side.corner), to = judged.vertex(side.face, side.corner + 1);
  for (const Ease& ease : judged.input.eases) {
    for (const auto& ends : ease.half_edges.rowwise()) {
      if (ends[0] == from && ends[1] == to) return ease.ratio;
    }
  }
  return 0;
}

/// Returns the lengths of an outline edge's sides, without the sides' own eases. Lists only sides in pieces that keep
/// their lengths.
std::vector<EdgeLengths> uneased_sides(const Judged& judged, const Edge& edge, bool is_stretched) {
  std::vector<EdgeLengths> sides;
  for (const Side& side : judged.sides().at(edge)) {
    const Piece& piece = judged.result.pieces[judged.piece_of(side.face)];
    if (keeps_lengths(piece)) sides.push_back(lengths_of(judged, edge, side, ease_of(judged, side), is_stretched));
  }
  return sides;
}

/// Returns the lowest index of the faces around a vertex that can be reached from `face` without crossing an outline.
int least_face_around(const Judged& judged, int face, int vertex) {
  std::set<int> reached{face};
  std::vector<int> front{face};
  while (!front.empty()) {
    const int at = front.back();
    front.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Edge edge = judged.edge(at, k);
      if (std::find(edge.begin(), edge.end(), vertex) == edge.end() || judged.is_outline(edge)) continue;
      for (const Side& side : judged.sides().at(edge)) {
        if (reached.insert(side.face).second) front.push_back(side.face);
      }
    }
  }
  return *reached.begin();
}

/// Returns the fans of faces on both sides of an edge, at one of its ends. The lowest face index identifies a fan.
std::multiset<int> fans_beside(const Judged& judged, const Edge& edge, int vertex) {
  std::multiset<int> fans;
  for (const Side& side : judged.sides().at(edge)) fans.insert(least_face_around(judged, side.face, vertex));
  return fans;
}

/// Returns the runs of a wire along outlines. A run ends where
///
/// - the wire leaves the outline,
/// - more or fewer than two outline edges meet, or
/// - the fans beside the wire change.
std::vector<std::vector<Edge>> runs_along_outlines(const Judged& judged, const Wire& wire) {
  std::vector<std::vector<Edge>> runs;
  const std::vector<Edge> edges = edges_of(wire);
  const auto goes_on = [&](std::size_t before, std::size_t after) {
    const int v = wire.vertices[after];
    return judged.is_outline(edges[before]) && judged.is_outline(edges[after]) && judged.num_outline_edges(v) == 2 &&
           fans_beside(judged, edges[before], v) == fans_beside(judged, edges[after], v);
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!judged.is_outline(edges[i])) continue;
    if (i == 0 || !goes_on(i - 1, i)) runs.emplace_back();
    runs.back().push_back(edges[i]);
  }
  const bool is_closed = wire.vertices.front() == wire.vertices.back();
  if (is_closed && runs.size() > 1 && goes_on(edges.size() - 1, 0)) {  // one run continues across the first vertex
    runs.front().insert(runs.front().end(), runs.back().begin(), runs.back().end());
    runs.pop_back();
  }
  return runs;
}

/// Checks that all sides of a run have one length variation h, within the wire's tolerance. A side with the ease r and
/// the target length l then has the planar length (1+r)(1+h) l.
void check_run(Judged& judged, const Wire& wire, const std::vector<Edge>& run) {
  Variations variations(is_all_rigid(judged.options) ? 0 : wire.tolerance, wire.ease);
  for (const Edge& edge : run) {
    for (const EdgeLengths& side : uneased_sides(judged, edge, wire.ease == 0)) variations.meet(side);
  }
  if (variations.gap() > 0) {
    judged.say("wire \"" + wire.name + "\" breaks its tolerance by " + std::to_string(variations.gap()) +
               " along the outline from " + name(run.front()));
  }
}

/// Checks the sides of an outline edge without a wire. A side with the ease r and the target length l must have the
/// planar length (1+r) l.
void check_plain_edge(Judged& judged, const Edge& edge) {
  Variations variations(0);
  for (const EdgeLengths& side : uneased_sides(judged, edge, true)) variations.meet(side);
  if (variations.gap() > 0) judged.say("outline " + name(edge) + " has the error " + std::to_string(variations.gap()));
}

}  // namespace

bool keeps_lengths(const Piece& piece) {
  return !piece.error || piece.error->code == ErrorCode::flipped_faces ||
         piece.error->code == ErrorCode::overlapping_faces;
}

void check_outline(Judged& judged, const Piece& piece) {
  std::set<Edge> with_wire;
  for (const Wire& wire : judged.input.wires) {
    for (const Edge& edge : edges_of(wire)) with_wire.insert(edge);
  }
  for (const int face : piece.source_face) {
    for (int k = 0; k < 3; ++k) {
      const Edge edge = judged.edge(face, k);
      if (judged.is_outline(edge)) {
        if (with_wire.count(edge) == 0) check_plain_edge(judged, edge);
        continue;
      }
      for (const Side& other : judged.sides().at(edge)) {  // the edge must have the same place in both faces
        const bool turned = judged.vertex(other.face, other.corner) != judged.vertex(face, k);
        const Eigen::Vector2d begin = judged.uv(other.face, other.corner + (turned ? 1 : 0));
        if (begin != judged.uv(face, k)) judged.say("torn at " + name(edge));
      }
    }
  }
}

void check_wires(Judged& judged) {
  for (const Wire& wire : judged.input.wires) {
    for (const std::vector<Edge>& run : runs_along_outlines(judged, wire)) check_run(judged, wire, run);
    const double tolerance = is_all_rigid(judged.options) ? 0 : wire.tolerance;
    if (std::isinf(tolerance)) continue;
    for (const auto& part : parts_of(judged, wire)) check_part(judged, wire, tolerance, part);
  }
}

}  // namespace wirewarp::test
