// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/eq1.h"

#include "base/planar.h"
#include "warp/inner/linear_angle_constraints.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {
namespace {

/// Returns node weights in proportion to 1/ℓ, where ℓ is the length of a node. The sum of Eq. (1) is then ∫ Δκ² ds (Δκ:
/// change of curvature), however the vertices are spaced.
Eigen::VectorXd node_weights(const WireNetwork& network, NodeWeight node_weight) {
  const auto num_nodes = static_cast<Eigen::Index>(network.nodes.size());
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(num_nodes);
  if (node_weight == NodeWeight::uniform) return weights;
  double total_length = 0;
  for (const WireNode& node : network.nodes) total_length += node.length;
  const double mean_length = total_length / static_cast<double>(num_nodes);
  for (Eigen::Index i = 0; i < num_nodes; ++i) {
    weights[i] = mean_length / network.nodes[static_cast<std::size_t>(i)].length;
  }
  return weights;
}

/// Returns headings that enclose the given angles. Between two edges with the angle θ, the heading turns by π − θ. An
/// edge that is walked backwards has the opposite heading.
Eigen::VectorXd lay_out_headings(const WireNetwork& network, const Eigen::VectorXd& angles) {
  std::vector<std::vector<int>> nodes_of_edge(network.edges.size());
  for (int i = 0; i < static_cast<int>(network.nodes.size()); ++i) {
    nodes_of_edge[network.nodes[i].in.edge].push_back(i);
    nodes_of_edge[network.nodes[i].out.edge].push_back(i);
  }
  const auto flip = [](WireHalfEdge h) { return h.reversed ? kPi : 0.0; };
  Eigen::VectorXd headings(static_cast<Eigen::Index>(network.edges.size()));
  std::vector<char> is_known(network.edges.size(), 0);
  std::vector<int> queue{0};
  headings[0] = 0;
  is_known[0] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int edge = queue[next];
    for (int i : nodes_of_edge[edge]) {
      const WireNode& node = network.nodes[i];
      const double turn = kPi - angles[i] + flip(node.in) - flip(node.out);
      const int other = node.in.edge == edge ? node.out.edge : node.in.edge;
      if (is_known[other]) continue;
      headings[other] = node.in.edge == edge ? headings[edge] + turn : headings[edge] - turn;
      is_known[other] = 1;
      queue.push_back(other);
    }
  }
  if (queue.size() < network.edges.size()) throw UnjoinedWires("Eq. (1) needs a network whose edges are connected");
  return headings;
}

/// Returns one number per edge that depends on the shape of the network, but not on its numbering. The term of `angle`
/// is equal on mirror-image edges. The term `torque` breaks the mirror symmetry.
Eigen::VectorXd edges_by_angle(const WireNetwork& network) {
  const auto num_edges = static_cast<Eigen::Index>(network.edges.size());
  Eigen::VectorXd angle = Eigen::VectorXd::Zero(num_edges);
  Eigen::VectorXd torque = Eigen::VectorXd::Zero(num_edges);
  Eigen::VectorXd count = Eigen::VectorXd::Zero(num_edges);
  for (const WireNode& node : network.nodes) {
    for (const int e : {node.in.edge, node.out.edge}) {
      angle[e] += node.surface_angle;
      count[e] += 1;
    }
    torque[node.in.edge] += node.surface_angle;
    torque[node.out.edge] -= node.surface_angle;
  }
  angle = angle.cwiseQuotient(count);
  Eigen::VectorXd length(num_edges);
  for (int e = 0; e < num_edges; ++e) length[e] = network.edges[e].length;
  const double mean = length.dot(angle) / length.sum();
  return length.cwiseProduct((angle.array() - mean).matrix()) / length.maxCoeff() + torque;
}

}  // namespace

Eq1::Eq1(const WireNetwork& network, NodeWeight node_weight) {
  const Eigen::VectorXd weights = node_weights(network, node_weight);
  const Eigen::VectorXd angles = project_on_angle_sums(network, weights);
  base_headings_ = lay_out_headings(network, angles);
  symmetry_breaker_ = edges_by_angle(network);
  for (int i = 0; i < static_cast<int>(network.nodes.size()); ++i) {
    const WireNode& node = network.nodes[i];
    nodes_.push_back({node.in.edge, node.out.edge, angles[i], node.surface_angle, weights[i]});
  }

  const auto start_loop = [&] { loops_.push_back({}); };
  const auto add_half_edge = [&](WireHalfEdge h) {
    loops_.back().edges.push_back(h.edge);
    loops_.back().signs.push_back(h.reversed ? -1.0 : 1.0);
  };
  for (const WirePatch& patch : network.patches) {
    start_loop();
    for (const WirePatch::Step& step : patch.loops[0]) add_half_edge(step.half_edge);
  }
  for (const std::vector<WireHalfEdge>& hole : network.holes) {
    start_loop();
    for (const WireHalfEdge& h : hole) add_half_edge(h);
  }
  for (Loop& loop : loops_) {
    double length = 0;
    for (int e : loop.edges) length += network.edges[e].length;
    for (double& sign : loop.signs) sign /= length;
  }

  std::vector<Eigen::Triplet<double>> entries;
  for (const Node& node : nodes_) {
    entries.emplace_back(node.in, node.in, node.weight);
    entries.emplace_back(node.out, node.out, node.weight);
    entries.emplace_back(node.in, node.out, -node.weight);
    entries.emplace_back(node.out, node.in, -node.weight);
  }
  laplacian_.resize(num_edges(), num_edges());
  laplacian_.setFromTriplets(entries.begin(), entries.end());
}

double Eq1::angle_variation(const Eigen::VectorXd& psi) const {
  double sum = 0;
  for (const Node& node : nodes_) {
    const double deviation = node.base - (psi[node.out] - psi[node.in]) - node.target;
    sum += node.weight * deviation * deviation;
  }
  return sum / 2;
}

Eigen::VectorXd Eq1::gradient(const Eigen::VectorXd& psi) const {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(num_edges());
  for (const Node& node : nodes_) {
    const double force = node.weight * (node.base - (psi[node.out] - psi[node.in]) - node.target);
    gradient[node.in] += force;
    gradient[node.out] -= force;
  }
  return gradient;
}

Eigen::VectorXd Eq1::closure(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths) const {
  const Eigen::VectorXd phi = headings(psi);
  const Eigen::ArrayXd x = lengths.array() * phi.array().cos();
  const Eigen::ArrayXd y = lengths.array() * phi.array().sin();
  Eigen::VectorXd closure = Eigen::VectorXd::Zero(num_closures());
  for (int p = 0; p < static_cast<int>(loops_.size()); ++p) {
    const Loop& loop = loops_[p];
    for (std::size_t b = 0; b < loop.edges.size(); ++b) {
      closure[2 * p] += loop.signs[b] * x[loop.edges[b]];
      closure[2 * p + 1] += loop.signs[b] * y[loop.edges[b]];
    }
  }
  return closure;
}

Eigen::SparseMatrix<double> Eq1::closure_jacobian(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths) const {
  const Eigen::VectorXd phi = headings(psi);
  std::vector<Eigen::Triplet<double>> entries;
  for (int p = 0; p < static_cast<int>(loops_.size()); ++p) {
    const Loop& loop = loops_[p];
    for (std::size_t b = 0; b < loop.edges.size(); ++b) {
      const int e = loop.edges[b];
      entries.emplace_back(2 * p, e, -loop.signs[b] * lengths[e] * std::sin(phi[e]));
      entries.emplace_back(2 * p + 1, e, loop.signs[b] * lengths[e] * std::cos(phi[e]));
    }
  }
  Eigen::SparseMatrix<double> jacobian(num_closures(), num_edges());
  jacobian.setFromTriplets(entries.begin(), entries.end());
  return jacobian;
}

Eigen::Matrix2Xd Eq1::gather(const Eigen::VectorXd& per_closure) const {
  Eigen::Matrix2Xd per_edge = Eigen::Matrix2Xd::Zero(2, num_edges());
  for (int p = 0; p < static_cast<int>(loops_.size()); ++p) {
    const Loop& loop = loops_[p];
    for (std::size_t b = 0; b < loop.edges.size(); ++b) {
      per_edge.col(loop.edges[b]) += loop.signs[b] * per_closure.segment<2>(2 * p);
    }
  }
  return per_edge;
}

Eigen::VectorXd Eq1::closure_hessian(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths,
                                     const Eigen::VectorXd& multipliers) const {
  return -lengths.cwiseProduct(closure_by_lengths(psi, multipliers));
}

Eigen::VectorXd Eq1::closure_by_lengths(const Eigen::VectorXd& psi, const Eigen::VectorXd& q) const {
  const Eigen::ArrayXd phi = headings(psi).array();
  const Eigen::Matrix2Xd along = gather(q);
  return (along.row(0).transpose().array() * phi.cos() + along.row(1).transpose().array() * phi.sin()).matrix();
}

Eigen::VectorXd Eq1::closure_by_headings_and_lengths(const Eigen::VectorXd& psi,
                                                     const Eigen::VectorXd& multipliers) const {
  const Eigen::ArrayXd phi = headings(psi).array();
  const Eigen::Matrix2Xd along = gather(multipliers);
  return (along.row(1).transpose().array() * phi.cos() - along.row(0).transpose().array() * phi.sin()).matrix();
}

}  // namespace wirewarp
