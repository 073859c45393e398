// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/bending.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/planar.h"
#include "surface/network/wire_lines.h"

namespace wirewarp {

Bending bending_of(const Chart& chart, const WireNetwork& network, double fairness,
                   const std::vector<double>& area_at) {
  std::vector<Bending::Term> terms;
  const auto shortest_wiggle = [&](const WireNode& node) { return fairness * std::sqrt(area_at[node.vertex.idx()]); };
  const auto add = [&](const WireNode& turn, double weight) {
    const double length_in = network.edges[turn.in.edge].length;
    const double length_out = network.edges[turn.out.edge].length;
    const Eigen::Matrix2d to_c = Eigen::Matrix2d::Identity() / length_out;
    const Eigen::Matrix2d to_a = Eigen::Rotation2Dd(kPi - turn.surface_angle).toRotationMatrix() / length_in;
    terms.push_back({{turn.vertex.idx(), chart.mesh.from_vertex_handle(half_edge(chart, network, turn.in)).idx(),
                      chart.mesh.to_vertex_handle(half_edge(chart, network, turn.out)).idx()},
                     {-to_c - to_a, to_a, to_c},
                     weight});
  };
  const auto weight_of_line = [&](const WireNode& node) { return std::pow(shortest_wiggle(node), 3) / node.length; };
  const auto weight_of_corner = [&](const WireNode& node) {
    return std::pow(shortest_wiggle(node), 3) / std::max(node.length, shortest_wiggle(node) / 8);
  };
  const WireLines lines = find_lines(chart, network);
  for (const WireNode& corner : lines.corners) add(corner, weight_of_corner(corner));
  for (const LineBend& bend : lines.bends) {
    const double weight = weight_of_line(bend.node);
    const double of_its_corners = weight_of_corner(bend.node);
    const bool passes_corners = bend.num_sectors > 1;
    if (!passes_corners) add(bend.node, weight);
    if (passes_corners && weight > of_its_corners) add(bend.node, (weight - of_its_corners) / bend.num_sectors);
  }
  return Bending(std::move(terms));
}

}  // namespace wirewarp
