// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/linear_angle_constraints.h"

#include <Eigen/SparseCholesky>
#include <map>

#include "base/planar.h"

namespace wirewarp {

Eigen::VectorXd project_on_angle_sums(const WireNetwork& network, const Eigen::VectorXd& weights) {
  const int num_nodes = static_cast<int>(network.nodes.size());
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> sums;
  const auto add_to_row = [&](int node) { entries.emplace_back(static_cast<int>(sums.size()), node, 1.0); };

  for (const WirePatch& patch : network.patches) {
    for (const WirePatch::Step& step : patch.loops[0]) add_to_row(step.node);
    sums.push_back((static_cast<double>(patch.loops[0].size()) - 2) * kPi);
  }
  for (const std::vector<int>& nodes : network.inner_vertex_nodes) {
    for (int node : nodes) add_to_row(node);
    sums.push_back(2 * kPi);
  }
  if (!network.holes.empty()) {
    std::map<int, std::vector<int>> nodes_of_vertex;
    for (int i = 0; i < num_nodes; ++i) nodes_of_vertex[network.nodes[i].vertex.idx()].push_back(i);
    std::vector<std::array<int, 2>> ends(network.edges.size(), {-1, -1});
    for (const WireNode& node : network.nodes) {
      ends[node.out.edge][node.out.reversed ? 1 : 0] = node.vertex.idx();
      ends[node.in.edge][node.in.reversed ? 0 : 1] = node.vertex.idx();
    }
    for (const std::vector<WireHalfEdge>& hole : network.holes) {
      for (const WireHalfEdge& h : hole) {
        for (int node : nodes_of_vertex[ends[h.edge][h.reversed ? 1 : 0]]) add_to_row(node);
      }
      sums.push_back((static_cast<double>(hole.size()) + 2) * kPi);
    }
  }

  const int num_rows = static_cast<int>(sums.size());
  Eigen::SparseMatrix<double> rows(num_rows, num_nodes);
  rows.setFromTriplets(entries.begin(), entries.end());
  const Eigen::Map<const Eigen::VectorXd> target(sums.data(), num_rows);

  Eigen::VectorXd angles(num_nodes);
  for (int i = 0; i < num_nodes; ++i) angles[i] = network.nodes[i].surface_angle;

  // Each node is in one patch row. Nodes off the outer boundary may be in one more row. So the rows A are independent,
  // and A W⁻¹ Aᵀ is positive definite.
  const Eigen::SparseMatrix<double> weighted = rows * weights.cwiseInverse().asDiagonal();
  const Eigen::SparseMatrix<double> normal = weighted * rows.transpose();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(normal);
  for (int pass = 0; pass < 2; ++pass) {  // the second pass removes rounding errors of the first
    angles += weighted.transpose() * factor.solve(target - rows * angles);
  }
  return angles;
}

}  // namespace wirewarp
