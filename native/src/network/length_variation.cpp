// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/length_variation.h"

#include "mesh/geometry.h"

namespace wirewarp {

Eigen::VectorXd length_variation(const Chart& chart, const Positions2& uv) {
  Eigen::VectorXd variation(static_cast<Eigen::Index>(chart.wire_parts.size()));
  for (int i = 0; i < variation.size(); ++i) {
    double length_3d = 0, length_2d = 0;
    for (const HalfedgeHandle h : chart.wire_parts[i].half_edges) {
      length_3d += edge_length(chart.mesh, h);
      length_2d += planar_length(chart.mesh, h, uv);
    }
    variation[i] = length_2d / length_3d - 1;
  }
  return variation;
}

}  // namespace wirewarp
