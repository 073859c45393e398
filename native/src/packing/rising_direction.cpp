// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/rising_direction.h"

#include <Eigen/Geometry>
#include <cmath>

namespace wirewarp {

Eigen::Vector2d rising_direction(const Chart& chart, const Positions2& uv, const Eigen::Vector3d& up) {
  constexpr double kLevel = 0.01;  // mean slope
  const Eigen::Vector3d unit_up = up.stableNormalized();
  const HalfEdgeMesh::Point origin = chart.mesh.point(VertexHandle(0));
  const auto height = [&](VertexHandle v) {
    const HalfEdgeMesh::Point p = chart.mesh.point(v) - origin;
    return unit_up.dot(Eigen::Vector3d(p[0], p[1], p[2]));
  };
  // Over the triangles the gradient sums up to what the outline alone says: the integral of height times its outward
  // normal (Gauss), whatever lies inside.
  Eigen::Vector2d gradient(0, 0);
  double twice_area = 0;
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) {
      const VertexHandle from = chart.mesh.from_vertex_handle(h);
      const VertexHandle to = chart.mesh.to_vertex_handle(h);
      const Eigen::Vector2d a = uv.row(from.idx()) - uv.row(0);
      const Eigen::Vector2d b = uv.row(to.idx()) - uv.row(0);
      gradient += (height(from) + height(to)) / 2 * Eigen::Vector2d(b.y() - a.y(), a.x() - b.x());
      twice_area += a.x() * b.y() - a.y() * b.x();
    }
  }
  const bool is_level = gradient.norm() <= kLevel * std::abs(twice_area) / 2;
  return is_level ? Eigen::Vector2d(0, 0) : gradient;
}

}  // namespace wirewarp
