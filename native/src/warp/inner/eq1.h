// SPDX-License-Identifier: GPL-3.0-or-later
// Equation (1) of the paper, in edge headings.
//
//   θ_i  planar angle, α_i surface angle of wire-node i          w_i  node weight
//   φ_e  heading of wire edge e in the plane                     l_e  its length
//   c_p  closure of loop p: Σ ± l_e (cos φ_e, sin φ_e) over its edges, divided by the loop's length
//
// The paper's unknowns are the angles, bound by linear rows (Σ(π−θ) = 2π per wire-patch, Σθ = 2π per inner vertex) and
// by the closure of each loop. One heading per wire edge, shared by the wire-patches on both its sides, makes every
// linear row hold by construction: with θ⁰ the angles of the starting headings and ψ the change of the headings,
// θ = θ⁰ − (ψ_out − ψ_in). Left are
//
//   min  ½ Σ w_i (θ_i − α_i)²   subject to   c_p = 0 for every wire-patch and every hole.
//
// The objective's Hessian is then a constant Laplacian on the wire edges and the closure's Hessian is diagonal. Holes
// need their own rows (the paper leaves them out): wire-patches that close and fit at every inner vertex still leave a
// gap around a hole.
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

  /// The wire edges of closure rows 2 loop and 2 loop + 1.
  const std::vector<int>& loop_edges(int loop) const { return loops_[static_cast<std::size_t>(loop)].edges; }

  /// A change of headings that no symmetry of the network leaves as it is, whatever the numbering: it singles out one
  /// of two mirror images. Edges between wide and narrow surface angles turn against each other. #edges.
  const Eigen::VectorXd& symmetry_breaker() const { return symmetry_breaker_; }

  /// φ: radians, one per wire edge, of its half-edge 0. #edges.
  Eigen::VectorXd headings(const Eigen::VectorXd& psi) const { return base_headings_ + psi; }

  /// ½ Σ w (θ − α)².
  double angle_variation(const Eigen::VectorXd& psi) const;

  /// Its gradient by ψ. #edges.
  Eigen::VectorXd gradient(const Eigen::VectorXd& psi) const;

  /// Its Hessian by ψ, constant: lower and upper triangle, positive but for the common turn of all edges.
  const Eigen::SparseMatrix<double>& laplacian() const { return laplacian_; }

  /// c for the given lengths. #closures: x and y of each loop.
  Eigen::VectorXd closure(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths) const;

  /// ∂c/∂ψ, #closures by #edges.
  Eigen::SparseMatrix<double> closure_jacobian(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths) const;

  /// Diagonal of ∂²(λᵀc)/∂ψ². #edges.
  Eigen::VectorXd closure_hessian(const Eigen::VectorXd& psi, const Eigen::VectorXd& lengths,
                                  const Eigen::VectorXd& multipliers) const;

  /// ∂(qᵀc)/∂l. #edges.
  Eigen::VectorXd closure_by_lengths(const Eigen::VectorXd& psi, const Eigen::VectorXd& q) const;

  /// Diagonal of ∂²(λᵀc)/∂ψ∂l: no edge's length acts on another's heading. #edges.
  Eigen::VectorXd closure_by_headings_and_lengths(const Eigen::VectorXd& psi, const Eigen::VectorXd& multipliers) const;

 private:
  struct Node {
    int in, out;    // wire edges
    double base;    // θ⁰
    double target;  // α
    double weight;  // w
  };
  struct Loop {
    std::vector<int> edges;
    std::vector<double> signs;  // over the length of the loop: +-1 / L
  };

  /// For each edge the sum over its loops of the two given values, with the edge's sign and over the loop's length.
  Eigen::Matrix2Xd gather(const Eigen::VectorXd& per_closure) const;

  std::vector<Node> nodes_;
  std::vector<Loop> loops_;
  Eigen::VectorXd base_headings_;
  Eigen::VectorXd symmetry_breaker_;
  Eigen::SparseMatrix<double> laplacian_;
};

}  // namespace wirewarp
