// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/solidity.h"

#include <cstddef>
#include <vector>

#include "base/planar.h"
#include "surface/orientation/convex_hull.h"

namespace wirewarp {

double solidity(const FlatPiece& piece) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& point : piece.uv.rowwise()) points.emplace_back(point);
  double twice_area = 0, twice_hull = 0;
  for (const FaceHandle f : piece.chart.mesh.faces()) {
    const HalfedgeHandle h = piece.chart.mesh.halfedge_handle(f);
    const auto corner = [&](HalfedgeHandle side) { return points[piece.chart.mesh.to_vertex_handle(side).idx()]; };
    const Eigen::Vector2d a = corner(h), b = corner(piece.chart.mesh.next_halfedge_handle(h)),
                          c = corner(piece.chart.mesh.prev_halfedge_handle(h));
    twice_area += cross(b - a, c - a);
  }
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  for (std::size_t i = 0; i < hull.size(); ++i) twice_hull += cross(hull[i], hull[(i + 1) % hull.size()]);
  return twice_area / twice_hull;
}

}  // namespace wirewarp
