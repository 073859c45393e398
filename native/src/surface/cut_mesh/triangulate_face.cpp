// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/cut_mesh/triangulate_face.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace wirewarp {
namespace {

using Pair = std::array<int, 2>;
using Triangle = std::array<int, 3>;

class Triangulation {
 public:
  explicit Triangulation(const FaceToDivide& face)
      : face_(face), count_(static_cast<int>(face.points.size())), is_joined_(count_, std::vector<char>(count_, 0)) {
    const int rim = static_cast<int>(face.sides.size());
    for (int i = 0; i < rim; ++i) join(i, (i + 1) % rim);
    for (const Pair& line : face.lines) join(line[0], line[1]);
    join_the_rest();
  }

  std::vector<Triangle> triangles() const;

 private:
  void join(int a, int b) {
    is_joined_[a][b] = is_joined_[b][a] = 1;
    edges_.push_back({a, b});
  }
  void join_the_rest();
  bool are_on_one_side(int a, int b) const;
  bool may_join(int a, int b) const;
  bool has_point_between(int a, int b) const;
  bool is_empty(int a, int b, int c) const;
  const FacePoint& at(int i) const { return face_.points[i]; }

  const FaceToDivide& face_;
  const int count_;
  std::vector<std::vector<char>> is_joined_;
  std::vector<Pair> edges_;
};

bool Triangulation::are_on_one_side(int a, int b) const {
  const int rim = static_cast<int>(face_.sides.size());
  if (a >= rim || b >= rim) return false;
  for (const int side : face_.sides[a]) {
    if (side == face_.sides[b][0] || side == face_.sides[b][1]) return true;
  }
  return false;
}

bool Triangulation::has_point_between(int a, int b) const {
  for (int i = 0; i < count_; ++i) {
    if (i == a || i == b || std::abs(doubled_area(at(a), at(b), at(i))) > kInLine) continue;
    const FacePoint line = at(b) - at(a);
    if (line.dot(at(i) - at(a)) > 0 && line.dot(at(b) - at(i)) > 0) return true;
  }
  return false;
}

bool Triangulation::may_join(int a, int b) const {
  if (is_joined_[a][b] != 0 || are_on_one_side(a, b) || has_point_between(a, b)) return false;
  return std::none_of(edges_.begin(), edges_.end(), [&](const Pair& edge) {
    const bool meets = edge[0] == a || edge[0] == b || edge[1] == a || edge[1] == b;
    return !meets && do_cross(at(a), at(b), at(edge[0]), at(edge[1]));
  });
}

/// Adds edges that do not cross other edges, the shortest first.
void Triangulation::join_the_rest() {
  std::vector<std::tuple<double, int, int>> pairs;
  for (int a = 0; a < count_; ++a) {
    for (int b = a + 1; b < count_; ++b) {
      pairs.emplace_back((face_.places.row(a) - face_.places.row(b)).squaredNorm(), a, b);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [length, a, b] : pairs) {
    if (may_join(a, b)) join(a, b);
  }
}

bool Triangulation::is_empty(int a, int b, int c) const {
  for (int i = 0; i < count_; ++i) {
    if (i == a || i == b || i == c) continue;
    if (doubled_area(at(a), at(b), at(i)) > -kInLine && doubled_area(at(b), at(c), at(i)) > -kInLine &&
        doubled_area(at(c), at(a), at(i)) > -kInLine) {
      return false;
    }
  }
  return true;
}

std::vector<Triangle> Triangulation::triangles() const {
  std::vector<Triangle> triangles;
  for (int a = 0; a < count_; ++a) {
    for (int b = a + 1; b < count_; ++b) {
      if (is_joined_[a][b] == 0) continue;
      for (int c = b + 1; c < count_; ++c) {
        if (is_joined_[a][c] == 0 || is_joined_[b][c] == 0) continue;
        const double area = doubled_area(at(a), at(b), at(c));
        if (area > kInLine && is_empty(a, b, c)) triangles.push_back({a, b, c});
        if (area < -kInLine && is_empty(a, c, b)) triangles.push_back({a, c, b});
      }
    }
  }
  const std::size_t rim = face_.sides.size();
  if (triangles.size() != 2 * face_.points.size() - rim - 2) {  // by Euler's formula
    throw std::logic_error("A face was not divided into triangles: lines in it cross or pass through points.");
  }
  return triangles;
}

double least_height(const FaceToDivide& face, const Triangle& triangle) {
  const auto at = [&](int k) -> Eigen::RowVector3d { return face.places.row(triangle[k]); };
  const Eigen::RowVector3d a = at(1) - at(0), b = at(2) - at(0);
  const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
  return a.cross(b).norm() / longest;
}

/// Returns the corner at which the edge from a to b starts; -1 if the triangle does not have this edge.
int corner_before(const Triangle& triangle, int a, int b) {
  for (int k = 0; k < 3; ++k) {
    if (triangle[k] == a && triangle[(k + 1) % 3] == b) return k;
  }
  return -1;
}

/// Two triangles that replace two other triangles with the same outline.
struct Flip {
  std::size_t first, second;
  Triangle one, other;
  double gain = 0;  // increase of the smaller height of the two triangles
};

/// Finds the flip with the largest gain, so that the result does not depend on the numbering. Returns whether there is
/// a gain.
bool find_best_flip(const FaceToDivide& face, const std::vector<Triangle>& triangles, Flip& best) {
  constexpr double kHigher = 1 + 1e-9;  // far above rounding, so that no edge flips back and forth
  best.gain = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      const Triangle &first = triangles[i], &second = triangles[j];
      for (int k = 0; k < 3; ++k) {
        const int a = first[k], b = first[(k + 1) % 3], c = first[(k + 2) % 3];
        const int there = corner_before(second, b, a);
        if (there < 0 || face.lines.count({std::min(a, b), std::max(a, b)}) != 0) continue;
        const int d = second[(there + 2) % 3];
        const Triangle one{c, a, d}, other{d, b, c};
        const auto is_turned = [&](const Triangle& t) {
          return doubled_area(face.points[t[0]], face.points[t[1]], face.points[t[2]]) <= kInLine;
        };
        if (is_turned(one) || is_turned(other)) continue;
        const double before = std::min(least_height(face, first), least_height(face, second));
        const double after = std::min(least_height(face, one), least_height(face, other));
        if (after > kHigher * before && after - before > best.gain) best = {i, j, one, other, after - before};
      }
    }
  }
  return best.gain > 0;
}

}  // namespace

bool do_cross(const FacePoint& a, const FacePoint& b, const FacePoint& c, const FacePoint& d) {
  const auto are_apart = [](double first, double second) {
    return (first > kInLine && second < -kInLine) || (first < -kInLine && second > kInLine);
  };
  return are_apart(doubled_area(a, b, c), doubled_area(a, b, d)) &&
         are_apart(doubled_area(c, d, a), doubled_area(c, d, b));
}

std::vector<std::array<int, 3>> triangulate(const FaceToDivide& face) {
  std::vector<Triangle> triangles = Triangulation(face).triangles();
  for (Flip flip; find_best_flip(face, triangles, flip);) {  // The loop ends, because flips increase heights.
    triangles[flip.first] = flip.one;
    triangles[flip.second] = flip.other;
  }
  return triangles;
}

}  // namespace wirewarp
