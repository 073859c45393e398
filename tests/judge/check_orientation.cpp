// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that placed pieces have the direction that Options::orientation chooses. Checks nothing if the chosen line
// depends on details of how wires are divided into parts.
#include <algorithm>
#include <optional>
#include <utility>

#include "checks.h"

namespace wirewarp::test {
namespace {

constexpr double kDirectionRounding = 1e-6;  // radians; allowed error of a direction
// Length of a line's chord over the line's length. Below this limit, the line's box must be upright instead of its
// chord.
constexpr double kShortChord = 0.1;
constexpr double kStraight = 0.087266462599716;  // 5 degrees
constexpr double kLevel = 0.01;                  // rise over distance; a piece that rises less counts as level

struct Line {
  std::vector<Eigen::Vector2d> points;
  double length = 0;
};

/// Appends an edge that starts at the input vertex a, with its planar positions on this side.
void append(const Judged& judged, const Side& side, int a, Line& line) {
  const int begin = judged.vertex(side.face, side.corner) == a ? 0 : 1;
  if (line.points.empty()) line.points.push_back(judged.uv(side.face, side.corner + begin));
  line.points.push_back(judged.uv(side.face, side.corner + 1 - begin));
  line.length += judged.length_2d(side);
}

bool runs_through(const Judged& judged, const Wire& wire, int piece) {
  const std::vector<Edge> edges = edges_of(wire);
  return std::any_of(edges.begin(), edges.end(),
                     [&](const Edge& edge) { return !judged.sides_in(edge, piece).empty(); });
}

/// Returns the points of an open wire that meets outlines only at its ends, if at all. Returns no points for other
/// wires.
Line uncut_wire(const Judged& judged, const Wire& wire, int piece) {
  Line line;
  const std::vector<int>& v = wire.vertices;
  if (v.front() == v.back()) return {};
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    const std::vector<Side> sides = judged.sides_in(edge_of(v[i], v[i + 1]), piece);
    if ((i > 0 && judged.is_outline_vertex(v[i])) || sides.size() != 2) return {};
    append(judged, sides[0], v[i], line);
  }
  return line;
}

void check_upright(Judged& judged, const Line& line, const std::string& what) {
  if (line.points.empty()) return;
  const Eigen::Vector2d chord = line.points.back() - line.points.front();
  if (chord.norm() > 1.001 * kShortChord * line.length) {
    if (std::abs(chord.x()) > kDirectionRounding * chord.norm() || chord.y() <= 0) judged.say(what + " is not upright");
  } else if (chord.norm() < 0.999 * kShortChord * line.length) {
    Eigen::Vector2d low = line.points[0], high = low;
    for (const Eigen::Vector2d& p : line.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    if (high.y() - low.y() < (1 - kDirectionRounding) * (high.x() - low.x()))
      judged.say("the box of " + what + " is not upright");
  }
}

/// Checks that the longest chain of the outline is upright, unless two chains are almost equally long. Chains run with
/// their piece on the left.
void check_longest_chain(Judged& judged, int number) {
  std::vector<std::pair<double, Line>> chains;  // with their lengths on the surface
  for (const BoundaryReport& boundary : judged.result.pieces[number].boundaries) {
    Line chain;
    double length = 0;
    for (std::size_t i = 0; i + 1 < boundary.vertices.size(); ++i) {
      const Edge edge = edge_of(boundary.vertices[i], boundary.vertices[i + 1]);
      length += judged.length_3d(edge);
      for (const Side& side : judged.sides_in(edge, number)) {
        const int v = boundary.vertices[i];
        if (judged.vertex(side.face, side.corner) == v) append(judged, side, v, chain);
      }
    }
    chains.emplace_back(length, chain);
  }
  std::sort(chains.begin(), chains.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  if (chains.empty()) return;
  if (chains.size() > 1 && chains[1].first >= (1 - 1e-4) * chains[0].first) return;  // either chain may be chosen
  check_upright(judged, chains[0].second, "the longest chain of the outline");
}

bool has_grain(const Judged& judged, int piece) {
  const int grain = judged.options.grain;
  return grain >= 0 && runs_through(judged, judged.input.wires[grain], piece);
}

void check_wire_upright(Judged& judged, int piece) {
  const std::vector<Wire>& wires = judged.input.wires;
  if (has_grain(judged, piece)) {
    return check_upright(judged, uncut_wire(judged, wires[judged.options.grain], piece), "the grain");
  }
  for (const Wire& wire : wires) {
    if (!runs_through(judged, wire, piece)) continue;
    return check_upright(judged, uncut_wire(judged, wire, piece), "the first wire");
  }
  check_longest_chain(judged, piece);
}

/// Checks that some consecutive outline edges point upward within 5 degrees, and are together at least as long as the
/// longest outline edge.
void check_straightest_section(Judged& judged, int number) {
  const Piece& piece = judged.result.pieces[number];
  double longest_edge = 0;
  std::map<int, Eigen::Vector2d> upright;  // upward edges of the outline, keyed by their first vertex in the piece
  std::map<int, int> next;
  for (const auto& [a, b] : judged.outline_of(piece)) {
    const Eigen::Vector2d edge = (piece.vertices.row(b) - piece.vertices.row(a)).transpose();
    longest_edge = std::max(longest_edge, edge.norm());
    if (std::abs(std::atan2(edge.x(), edge.y())) > kStraight + kDirectionRounding) continue;
    upright[a] = edge;
    next[a] = b;
  }
  double longest_section = 0;
  for (const auto& [first, edge] : upright) {
    Eigen::Vector2d section = edge;
    for (int v = next.at(first); upright.count(v) && v != first; v = next.at(v)) section += upright.at(v);
    longest_section = std::max(longest_section, section.norm());
  }
  if (longest_section < (1 - 1e-4) * longest_edge) judged.say("no straight section of the outline is upright");
}

/// Returns the mean gradient of the height over the piece, or nullopt if about half of the piece is flipped.
std::optional<Eigen::Vector2d> mean_rise(const Judged& judged, const Piece& piece) {
  const Eigen::Vector3d up = Eigen::Vector3d(judged.options.up.data()).stableNormalized();
  const Eigen::Vector3d origin = judged.position(judged.vertex(piece.source_face[0], 0));
  Eigen::Vector2d sum(0, 0);
  double area = 0, whole = 0;
  for (const int face : piece.source_face) {
    for (int k = 0; k < 3; ++k) {
      const double height = up.dot(judged.position(judged.vertex(face, k)) - origin);
      const Eigen::Vector2d across = judged.uv(face, k + 2) - judged.uv(face, k + 1);
      // This vector is the inward normal of the opposite side, and is as long as this side.
      sum += height / 2 * Eigen::Vector2d(-across.y(), across.x());
    }
    const Eigen::Vector2d a = judged.uv(face, 1) - judged.uv(face, 0), b = judged.uv(face, 2) - judged.uv(face, 0);
    const double of_face = (a.x() * b.y() - a.y() * b.x()) / 2;
    area += of_face;
    whole += std::abs(of_face);
  }
  if (std::abs(area) < 1e-6 * whole) return std::nullopt;
  return sum / area;
}

}  // namespace

void check_orientation(Judged& judged, int number) {
  const Orientation orientation = judged.options.orientation;
  if (orientation == Orientation::boundary) return check_straightest_section(judged, number);
  if (orientation == Orientation::up || (orientation == Orientation::grain && !has_grain(judged, number))) {
    const std::optional<Eigen::Vector2d> rise = mean_rise(judged, judged.result.pieces[number]);
    if (!rise) return;
    if (rise->norm() > 1.001 * kLevel) {
      const bool is_up = std::abs(rise->x()) <= kDirectionRounding * rise->norm() && rise->y() > 0;
      if (!is_up) judged.say("the direction up in space is not up in the piece");
      return;
    }
    if (rise->norm() > 0.999 * kLevel) return;  // rounding errors would decide whether the piece is level
  }
  check_wire_upright(judged, number);
}

}  // namespace wirewarp::test
