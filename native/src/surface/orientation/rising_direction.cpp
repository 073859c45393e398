// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/orientation/rising_direction.h"

#include <Eigen/Geometry>
#include <cmath>

#include "surface/charts/enclosed_area.h"

namespace wirewarp {

Eigen::Vector2d rising_direction(const Chart& chart, const Positions2& uv, const Eigen::Vector3d& up) {
  constexpr double kLevel = 0.01;  // mean slope up to which a piece counts as level: 0.6 degrees, which nobody sees
  const Eigen::Vector3d unit_up = up.stableNormalized();
  const HalfEdgeMesh::Point origin = chart.mesh.point(VertexHandle(0));
  const auto height = [&](VertexHandle v) {
    const HalfEdgeMesh::Point p = chart.mesh.point(v) - origin;
    return unit_up.dot(Eigen::Vector3d(p[0], p[1], p[2]));
  };
  // The gradient summed over the triangles depends on the outline alone: it is the integral of height times the outward
  // normal along the outline (Gauss).
  Eigen::Vector2d gradient(0, 0);
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) {
      const VertexHandle from = chart.mesh.from_vertex_handle(h);
      const VertexHandle to = chart.mesh.to_vertex_handle(h);
      const Eigen::Vector2d side = uv.row(to.idx()) - uv.row(from.idx());
      gradient += (height(from) + height(to)) / 2 * Eigen::Vector2d(side.y(), -side.x());
    }
  }
  const double area = enclosed_area(chart, uv);  // negative if most of a failed piece is flipped
  const bool is_level = gradient.norm() <= kLevel * std::abs(area);
  return is_level ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(std::copysign(1.0, area) * gradient);
}

}  // namespace wirewarp
