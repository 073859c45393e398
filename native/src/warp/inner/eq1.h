// SPDX-License-Identifier: GPL-3.0-or-later
// Equation (1) of the paper, in edge headings.
//
//   θ_i  planar angle, α_i surface angle of wire-node i          w_i  node weight
//   φ_e  heading of wire edge e in the plane                     l_e  its length
//   c_p  closure of loop p: Σ ± l_e (cos φ_e, sin φ_e) over its edges, divided by the loop's length
//
// The paper's unknowns are the angles, with linear constraints (Σ(π−θ) = 2π per wire-patch, Σθ = 2π per inner vertex)
// and the closure of each loop. Here, the unknown is one heading per wire edge, which the wire-patches on both its
// sides share. The angles then satisfy every linear constraint: θ = θ⁰ − (ψ_out − ψ_in), with θ⁰ the angles of the
// starting headings and ψ the change of the headings. The remaining problem is
//
//   min  ½ Σ w_i (θ_i − α_i)²   subject to   c_p = 0 for every wire-patch and every hole.
//
// The objective's Hessian is a constant Laplacian on the wire edges, and the closure's Hessian is diagonal. Holes need
// constraints, too, which the paper omits: even if all wire-patches close and fit at every inner vertex, a gap can
// remain around a hole.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "surface/network/wire_network.h"
#include "wirewarp/options.h"

namespace wirewarp {

class Eq1 {
 public:
  Eq1(const WireNetwork& network, NodeWeight node_weight);

  int num_edges() const { return static_cast<int>(base_headings_.size()); }
  int num_closures() const { return 2 * static_cast<int>(loops_.size()); }

  /// Returns the wire edges in the closure rows 2 loop and 2 loop + 1.
  const std::vector<int>& loop_edges(int loop) const { return loops_[static_cast<std::size_t>(loop)].edges; }

  /// Returns a change of headings, #edges, that selects one of two mirror-image solutions. No symmetry of the network
  /// maps this change to itself. The change does not depend on the numbering.
  const Eigen::VectorXd& symmetry_breaker() const { return symmetry_breaker_; }

  /// Returns φ, #edges: the heading in radians of each wire edge's half-edge 0.
  Eigen::VectorXd headings(const Eigen::VectorXd& psi) const { return base_headings_ + psi; }

  /// Returns the objective ½ Σ w (θ − α)².
  double angle_variation(const Eigen::VectorXd& psi) const;

  /// Returns the gradient of the objective with respect to ψ, #edges.
  Eigen::VectorXd gradient(const Eigen::VectorXd& psi) const;

  /// Returns the Hessian of the objective with respect to ψ, both triangles. It is constant, and positive definite
  /// except for the rotation of all edges together.
  const Eigen::SparseMatrix<double>& laplacian() const { return laplacian_; }

  /// Returns c for the given lengths. #closures: x and y of each loop.
  Eigen::VectorXd closure(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths) const;

  /// Returns ∂c/∂ψ, #closures by #edges.
  Eigen::SparseMatrix<double> closure_jacobian(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths) const;

  /// Returns the diagonal of ∂²(λᵀc)/∂ψ², #edges.
  Eigen::VectorXd closure_hessian(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths,
                                  const Eigen::VectorXd& multipliers) const;

  /// Returns ∂(qᵀc)/∂l, #edges.
  Eigen::VectorXd closure_by_lengths(const Eigen::VectorXd& psi, const Eigen::VectorXd& q) const;

  /// Returns the diagonal of ∂²(λᵀc)/∂ψ∂l, #edges. Other entries are zero, because each term of a closure has one edge.
  Eigen::VectorXd closure_by_headings_and_lengths(const Eigen::VectorXd& psi, const Eigen::VectorXd& multipliers) const;

 private:
  struct Node {
    int in, out;    // indices of wire edges
    double base;    // θ⁰
    double target;  // α
    double weight;  // w
  };
  struct Loop {
    std::vector<int> edges;
    std::vector<double> signs;  // ±1 / length of the loop
  };

  /// Returns for each edge Σ ± (x, y) / length over its loops, where (x, y) are the loop's entries of per_closure.
  Eigen::Matrix2Xd gather(const Eigen::VectorXd& per_closure) const;

  std::vector<Node> nodes_;
  std::vector<Loop> loops_;
  Eigen::VectorXd base_headings_;
  Eigen::VectorXd symmetry_breaker_;
  Eigen::SparseMatrix<double> laplacian_;
};

}  // namespace wirewarp
