// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar_overlap.h"

#include <algorithm>
#include <numeric>

namespace wirewarp::test {
namespace {

/// Returns the largest distance of the second triangle beyond a side of the first triangle. The result is negative if
/// no side has the whole second triangle beyond it.
double distance_beyond(const PlanarTriangle& first, const PlanarTriangle& second) {
  double farthest = -1e300;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d side = first[(k + 1) % 3] - first[k];
    const Eigen::Vector2d outward = Eigen::Vector2d(side.y(), -side.x()) / side.norm();
    double nearest = 1e300;
    for (const Eigen::Vector2d& corner : second) nearest = std::min(nearest, outward.dot(corner - first[k]));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace

long double doubled_area(const PlanarTriangle& t) {
  const auto x = [&](std::size_t k) { return static_cast<long double>(t[k].x()) - static_cast<long double>(t[0].x()); };
  const auto y = [&](std::size_t k) { return static_cast<long double>(t[k].y()) - static_cast<long double>(t[0].y()); };
  return x(1) * y(2) - x(2) * y(1);
}

std::pair<int, int> find_overlap(const std::vector<PlanarTriangle>& triangles) {
  struct Box {
    Eigen::Vector2d low;
    Eigen::Vector2d high;
  };
  std::vector<Box> boxes;
  double size = 0;
  for (const PlanarTriangle& t : triangles) {
    boxes.push_back({t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])});
    size = std::max({size, boxes.back().low.cwiseAbs().maxCoeff(), boxes.back().high.cwiseAbs().maxCoeff()});
  }
  const double rounding = 1e-9 * size;
  std::vector<std::size_t> order(triangles.size());  // indices of triangles, from left to right
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return boxes[i].low.x() < boxes[j].low.x(); });
  for (std::size_t first = 0; first < order.size(); ++first) {
    const std::size_t i = order[first];
    for (std::size_t second = first + 1; second < order.size(); ++second) {
      const std::size_t j = order[second];
      if (boxes[j].low.x() > boxes[i].high.x()) break;
      if (boxes[i].low.y() > boxes[j].high.y() || boxes[j].low.y() > boxes[i].high.y()) continue;
      const double apart =
          std::max(distance_beyond(triangles[i], triangles[j]), distance_beyond(triangles[j], triangles[i]));
      if (apart < -rounding) return {static_cast<int>(i), static_cast<int>(j)};
    }
  }
  return {-1, -1};
}

}  // namespace wirewarp::test
