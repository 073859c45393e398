// SPDX-License-Identifier: GPL-3.0-or-later
// ψ(h), first half: the planar angles of the wire network for given lengths (paper II-A, Eq. 1).
#pragma once

#include <limits>
#include <utility>

#include "warp/inner/eq1.h"
#include "warp/inner/kkt_system.h"

namespace wirewarp {

struct InnerSolution {
  Eigen::VectorXd headings;                                              // φ, radians, #wire edges
  Eigen::VectorXd psi;                                                   // their change from the starting headings
  Eigen::VectorXd multipliers;                                           // λ of the closures, #closures
  double closure_residual = 0;                                           // largest gap of a loop / its length
  double projected_gradient = std::numeric_limits<double>::quiet_NaN();  // largest entry of ∇F + Jᵀλ; NaN: not sought
  int num_solves = 0;                                                    // factorizations
  bool is_feasible = false;                                              // every loop closes
  bool is_minimum = false;  // stationary to 1e-10 with the right inertia (or closing is all that was asked for)
};

/// Solves Eq. (1) on one network for as many lengths as wanted. All throw Stopped, and FactorizationFailed at a zero
/// pivot.
class InnerProblem {
 public:
  /// stop: checked before each factorization, and before each step along closed loops.
  InnerProblem(const WireNetwork& network, NodeWeight node_weight, StopToken stop = {})
      : eq1_(network, node_weight), kkt_(eq1_, network, std::move(stop)) {}

  /// The local minimum of Eq. (1) reached from the surface angles (Inner::minimum), or the first point where every
  /// loop closes (Inner::least_norm). lengths: positive, scene units, #wire edges.
  InnerSolution solve(const Eigen::VectorXd& lengths, Inner inner);

  /// The local minimum of Eq. (1) for these lengths reached from the solution for others, which keeps to one branch of
  /// minima where there are several, and takes few factorizations.
  InnerSolution follow(const InnerSolution& from, const Eigen::VectorXd& lengths);

  /// Factors the optimality system at a solution that is a minimum, for the derivatives there: φ follows the lengths
  /// along the minima of Eq. (1). Each takes one solve.
  void linearize(const InnerSolution& solution, const Eigen::VectorXd& lengths);

  /// The change of φ with a change of lengths. #wire edges.
  Eigen::VectorXd change_of_headings(const InnerSolution& solution, const Eigen::VectorXd& change_of_lengths) const;

  /// For a function E(φ, l) of the solved network: its derivative by the lengths alone. by_headings, by_lengths: ∂E/∂φ,
  /// ∂E/∂l at the solution. #wire edges each.
  Eigen::VectorXd total_derivative(const InnerSolution& solution, const Eigen::VectorXd& by_headings,
                                   const Eigen::VectorXd& by_lengths) const;

  const StopToken& stop() const { return kkt_.stop(); }

  int num_factorizations() const { return kkt_.num_factorizations(); }

 private:
  InnerSolution solve_from(const Eigen::VectorXd& start, const Eigen::VectorXd& lengths, Inner inner);
  bool close_loops(const Eigen::VectorXd& lengths, Eigen::VectorXd& psi);
  bool restore(const Eigen::VectorXd& lengths, Eigen::VectorXd& psi) const;
  bool minimize(const Eigen::VectorXd& lengths, InnerSolution& solution);
  bool factor_downhill(const Eigen::VectorXd& closure_hessian, const Eigen::SparseMatrix<double>& jacobian,
                       double& share);
  Eigen::VectorXd inverse_iteration(Eigen::VectorXd turn) const;
  bool move(const Eigen::VectorXd& lengths, const Eigen::VectorXd& direction, double t, double decrease,
            Eigen::VectorXd& psi, double& value) const;
  bool leave_saddle(const Eigen::VectorXd& lengths, const Eigen::VectorXd& closure_hessian, double at_least,
                    Eigen::VectorXd& psi, double& value) const;

  Eq1 eq1_;
  KktSystem kkt_;
};

}  // namespace wirewarp
