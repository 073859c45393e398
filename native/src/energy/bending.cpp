// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/bending.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/planar.h"
#include "surface/network/wire_lines.h"

namespace wirewarp {

Bending::Bending(const Chart& chart, const WireNetwork& network, double fairness, const std::vector<double>& area_at) {
  const auto shortest_wiggle = [&](const WireNode& node) { return fairness * std::sqrt(area_at[node.vertex.idx()]); };
  const auto add = [&](const WireNode& turn, double weight) {
    const double length_in = network.edges[turn.in.edge].length;
    const double length_out = network.edges[turn.out.edge].length;
    Node node;
    node.a = chart.mesh.from_vertex_handle(half_edge(chart, network, turn.in)).idx();
    node.b = turn.vertex.idx();
    node.c = chart.mesh.to_vertex_handle(half_edge(chart, network, turn.out)).idx();
    node.weight = weight;
    node.to_c = Eigen::Matrix2d::Identity() / length_out;
    node.to_a = Eigen::Rotation2Dd(kPi - turn.surface_angle).toRotationMatrix() / length_in;
    node.to_b = -node.to_c - node.to_a;
    nodes_.push_back(node);
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
}

Eigen::Vector2d Bending::Node::residual(const Positions2& uv) const {
  // Computes differences first, because positions may be far larger than edges.
  const Eigen::Vector2d in = (uv.row(b) - uv.row(a)).transpose(), out = (uv.row(c) - uv.row(b)).transpose();
  return to_c * out - to_a * in;
}

double Bending::value(const Positions2& uv) const {
  double sum = 0;
  for (const Node& node : nodes_) sum += node.weight * node.residual(uv).squaredNorm();
  return sum / 2;
}

double Bending::add_gradient(const Positions2& uv, Positions2& gradient) const {
  double sum = 0;
  for (const Node& node : nodes_) {
    const Eigen::Vector2d r = node.residual(uv);
    const Eigen::Vector2d force = node.weight * r;
    gradient.row(node.a) += (node.to_a.transpose() * force).transpose();
    gradient.row(node.b) += (node.to_b.transpose() * force).transpose();
    gradient.row(node.c) += (node.to_c.transpose() * force).transpose();
    sum += force.dot(r);
  }
  return sum / 2;
}

double Bending::value_of_rounding(double error) const {
  double sum = 0;
  for (const Node& node : nodes_) {
    sum += node.weight * (node.to_a.squaredNorm() + node.to_b.squaredNorm() + node.to_c.squaredNorm());
  }
  return error * error * sum / 2;
}

void Bending::list_pairs(std::vector<VertexPair>& pairs) const {
  for (const Node& node : nodes_) {
    pairs.push_back({node.a, node.b});
    pairs.push_back({node.b, node.c});
    pairs.push_back({node.a, node.c});
  }
}

void Bending::add_hessian(VertexMatrix& hessian) const {
  for (const Node& node : nodes_) {
    const int vertices[3] = {node.a, node.b, node.c};
    const Eigen::Matrix2d* rows[3] = {&node.to_a, &node.to_b, &node.to_c};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Eigen::Matrix2d block = node.weight * rows[i]->transpose() * *rows[j];
        if (vertices[i] > vertices[j]) hessian.add(hessian.block(vertices[i], vertices[j]), block);
        if (vertices[i] == vertices[j]) hessian.add_diagonal(vertices[i], block);  // a = c around a slit of one edge
      }
    }
  }
}

}  // namespace wirewarp
