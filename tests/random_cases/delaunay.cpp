// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"

#include <algorithm>
#include <set>
#include <utility>

namespace wirewarp::test {
namespace {

using Point = Eigen::Matrix<long double, 2, 1>;
using Triangle = std::array<int, 3>;

long double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns whether p is inside the circle through the corners of a counter-clockwise triangle.
bool is_in_circle(const std::vector<Point>& points, const Triangle& triangle, const Point& p) {
  const Point a = points[static_cast<std::size_t>(triangle[0])] - p;
  const Point b = points[static_cast<std::size_t>(triangle[1])] - p;
  const Point c = points[static_cast<std::size_t>(triangle[2])] - p;
  return a.squaredNorm() * cross(b, c) + b.squaredNorm() * cross(c, a) + c.squaredNorm() * cross(a, b) > 0;
}

}  // namespace

std::vector<Triangle> delaunay(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d low = points.front(), high = points.front();
  std::vector<Point> all;
  for (const Eigen::Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    all.emplace_back(p.cast<long double>());
  }
  const int count = static_cast<int>(points.size());
  const Point middle = ((low + high) / 2).cast<long double>();
  const long double far = 1000 * static_cast<long double>((high - low).norm());
  for (const Point& direction : {Point(-1, -1), Point(1, -1), Point(0, 1)}) all.emplace_back(middle + far * direction);

  std::vector<Triangle> triangles{{count, count + 1, count + 2}};
  for (int v = 0; v < count; ++v) {
    const auto keeps = [&](const Triangle& t) { return !is_in_circle(all, t, all[static_cast<std::size_t>(v)]); };
    const auto cavity = std::stable_partition(triangles.begin(), triangles.end(), keeps);
    std::set<std::pair<int, int>> rim;  // border of the cavity, directed, with the cavity on the left
    for (auto t = cavity; t != triangles.end(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = (*t)[k], to = (*t)[(k + 1) % 3];
        if (rim.erase({to, from}) == 0) rim.insert({from, to});
      }
    }
    triangles.erase(cavity, triangles.end());
    for (const auto& [from, to] : rim) triangles.push_back({from, to, v});
  }
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&](const Triangle& t) { return *std::max_element(t.begin(), t.end()) >= count; }),
                  triangles.end());
  return triangles;
}

}  // namespace wirewarp::test
