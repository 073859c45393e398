// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/network/length_variation.h"

#include "surface/mesh/geometry.h"

namespace wirewarp {

Eigen::VectorXd length_variation(const Chart& chart, const Positions2& uv) {
  Eigen::VectorXd variation(static_cast<Eigen::Index>(chart.wire_parts.size()));
  for (int i = 0; i < variation.size(); ++i) {
    double target = 0, flat = 0;
    for (const HalfedgeHandle h : chart.wire_parts[i].half_edges) {
      target += length_ratio(chart, h) * edge_length(chart.mesh, h);
      flat += planar_length(chart.mesh, h, uv);
    }
    variation[i] = flat / target - 1;
  }
  return variation;
}

std::vector<double> variations_of(const Chart& chart, const Eigen::VectorXd& solver) {
  std::vector<double> variation;
  for (const WirePart& part : chart.wire_parts) {
    variation.push_back(variation_of(part, solver[static_cast<Eigen::Index>(variation.size())]));
  }
  return variation;
}

}  // namespace wirewarp
