// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/enclosed_area.h"

#include "base/planar.h"

namespace wirewarp {

double enclosed_area(const Chart& chart, const Positions2& uv) {
  double twice_area = 0;
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) {
      const Eigen::Vector2d a = uv.row(chart.mesh.from_vertex_handle(h).idx()) - uv.row(0);
      const Eigen::Vector2d b = uv.row(chart.mesh.to_vertex_handle(h).idx()) - uv.row(0);
      twice_area += cross(a, b);
    }
  }
  return twice_area / 2;
}

}  // namespace wirewarp
