// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <queue>
#include <utility>

#include "checks.h"

namespace wirewarp::test {
namespace {

// Largest gaps where faces of an unfolded surface meet again. kCloses is a share of the piece's size, and kStrain is a
// share of the length of the common side.
constexpr double kCloses = 1e-11, kStrain = 1e-7;

// Largest E (Eq. 4), divided by the 3D area, of a shape without distortion:
// - kUndistorted: from rounding errors only
// - kUndistortedAngles: also from the angle error at which the solver of Eq. (1) stops
constexpr double kUndistorted = 1e-12, kUndistortedAngles = 1e-9;

double triangle_area(const PlanarTriangle& t) { return static_cast<double>(doubled_area(t)) / 2; }

/// Returns the planar position of a face's third corner. The face is on the left of its planar side from a to b.
Eigen::Vector2d place_third(const Judged& judged, const Side& side, const Eigen::Vector2d& a,
                            const Eigen::Vector2d& b) {
  const Eigen::Vector3d origin = judged.position(judged.vertex(side.face, side.corner));
  const Eigen::Vector3d along = judged.position(judged.vertex(side.face, side.corner + 1)) - origin;
  const Eigen::Vector3d third = judged.position(judged.vertex(side.face, side.corner + 2)) - origin;
  const double ahead = third.dot(along) / along.squaredNorm();
  const double aside = along.cross(third).norm() / along.squaredNorm();
  const Eigen::Vector2d planar = b - a;
  return a + ahead * planar + aside * Eigen::Vector2d(-planar.y(), planar.x());
}

/// Unfolds the faces of a piece one by one, across the longest edge first. Returns nullopt if gaps remain where faces
/// meet again.
std::optional<std::map<int, PlanarTriangle>> unfold(const Judged& judged, const Piece& piece) {
  std::map<int, PlanarTriangle> placed;                              // keyed by face
  std::priority_queue<std::pair<double, std::array<int, 2>>> front;  // side length, face, corner where the side starts
  double size = 0;
  const auto longest_side = [&](int face) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) longest = std::max(longest, judged.length_3d(judged.edge(face, k)));
    return longest;
  };
  const auto place = [&](const Side& side, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    PlanarTriangle& triangle = placed[side.face];
    triangle[side.corner] = a;
    triangle[(side.corner + 1) % 3] = b;
    triangle[(side.corner + 2) % 3] = place_third(judged, side, a, b);
    for (int k = 0; k < 3; ++k) {
      const Edge edge = judged.edge(side.face, k);
      size = std::max(size, judged.length_3d(edge));
      if (!judged.is_outline(edge)) front.push({judged.length_3d(edge), {side.face, k}});
    }
  };
  const int first = piece.source_face[0];
  place({first, 0}, {0, 0}, {judged.length_3d(judged.edge(first, 0)), 0});
  while (!front.empty()) {
    const auto [face, corner] = front.top().second;
    front.pop();
    const Eigen::Vector2d a = placed.at(face)[corner], b = placed.at(face)[(corner + 1) % 3];
    for (const Side& other : judged.sides().at(judged.edge(face, corner))) {
      if (other.face == face) continue;
      const auto known = placed.find(other.face);
      if (known == placed.end()) {
        place(other, b, a);
        continue;
      }
      const double off =
          std::max((known->second[other.corner] - b).norm(), (known->second[(other.corner + 1) % 3] - a).norm());
      const double side_length = (b - a).norm();
      // The error of a short side grows over a long face, so the limit is multiplied by side_length / longest.
      const double longest = std::max(longest_side(face), longest_side(other.face));
      if (!(off <= std::min(kCloses * size, kStrain * side_length * side_length / longest))) return std::nullopt;
    }
  }
  return placed;
}

/// Returns E of Eq. (4) of the map between two triangles. With the similarity part z and the reflection part w of the
/// map, E is 2 (|z| - 1)² + 2 |w|², times the area of the first triangle.
double energy(const PlanarTriangle& from, const PlanarTriangle& to) {
  Eigen::Matrix2d before, after;
  before << from[1] - from[0], from[2] - from[0];
  after << to[1] - to[0], to[2] - to[0];
  const Eigen::Matrix2d map = after * before.inverse();
  const double z = std::hypot(map(0, 0) + map(1, 1), map(1, 0) - map(0, 1)) / 2;
  const double w = std::hypot(map(0, 0) - map(1, 1), map(1, 0) + map(0, 1)) / 2;
  return triangle_area(from) * (2 * (z - 1) * (z - 1) + 2 * w * w);
}

}  // namespace

bool has_other_outline(const Judged& judged, const Piece& piece) {
  const int number = judged.piece_of(piece.source_face.front());
  const auto is_in_piece = [&](const Edge& edge) { return !judged.sides_in(edge, number).empty(); };
  for (const Wire& wire : judged.input.wires) {
    if (wire.tolerance == 0 && wire.ease == 0) continue;
    for (const Edge& edge : edges_of(wire)) {
      if (judged.is_outline(edge) && is_in_piece(edge)) return true;
    }
  }
  for (const Ease& ease : judged.input.eases) {
    for (const auto& ends : ease.half_edges.rowwise()) {
      if (is_in_piece(edge_of(ends[0], ends[1]))) return true;
    }
  }
  return false;
}

void check_unfolding(Judged& judged, const Piece& piece) {
  if (judged.unstretched || has_other_outline(judged, piece)) return;
  const bool is_refined = judged.options.method == Method::refined;
  if (is_refined && judged.may_stop_anywhere()) return;
  // The paper's methods may flip faces or stop early, and then say so in the report.
  if (!is_refined && (piece.error || piece.report.termination != Termination::converged)) return;
  const auto unfolded = unfold(judged, piece);
  if (!unfolded) return;
  std::vector<PlanarTriangle> triangles;
  double area = 0;
  for (const auto& [face, triangle] : *unfolded) {
    triangles.push_back(triangle);
    area += triangle_area(triangle);
  }
  if (triangles.size() != piece.source_face.size() || find_overlap(triangles).first >= 0) return;
  if (piece.error) {
    judged.say(std::string("a piece that unfolds has the error ") + describe(piece.error->code).name);
    return;
  }
  double sum = 0;
  for (const auto& [face, triangle] : *unfolded) {
    PlanarTriangle flat{judged.uv(face, 0), judged.uv(face, 1), judged.uv(face, 2)};
    if (judged.options.mirror) {
      for (Eigen::Vector2d& corner : flat) corner.x() *= -1;
    }
    sum += energy(triangle, flat);
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", sum / area);
  const double most = is_refined ? kUndistorted : kUndistortedAngles;
  if (!(sum <= most * area)) judged.say(std::string("a piece that unfolds is distorted by ") + text);
}

}  // namespace wirewarp::test
