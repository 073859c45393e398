// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/solidity.h"

#include <cstddef>
#include <vector>

#include "base/planar.h"
#include "surface/charts/enclosed_area.h"
#include "surface/orientation/convex_hull.h"

namespace wirewarp {

double solidity(const FlatPiece& piece) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& point : piece.uv.rowwise()) points.emplace_back(point);
  double twice_hull = 0;
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  for (std::size_t i = 0; i < hull.size(); ++i) twice_hull += cross(hull[i], hull[(i + 1) % hull.size()]);
  return 2 * enclosed_area(piece.chart, piece.uv) / twice_hull;
}

}  // namespace wirewarp
