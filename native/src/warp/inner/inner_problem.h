// SPDX-License-Identifier: GPL-3.0-or-later
// The first half of ψ(h): the planar angles of the wire network for given lengths (paper II-A, Eq. 1).
#pragma once

#include <limits>
#include <utility>

#include "warp/inner/eq1.h"
#include "warp/inner/kkt_system.h"

namespace wirewarp {

struct InnerSolution {
  Eigen::VectorXd headings;                                              // φ, radians, #wire edges
  Eigen::VectorXd psi;                                                   // change of φ from the starting headings
  Eigen::VectorXd multipliers;                                           // λ of the closures, #closures
  double closure_residual = 0;                                           // largest gap of a loop, divided by its length
  double projected_gradient = std::numeric_limits<double>::quiet_NaN();  // largest entry of ∇F + Jᵀλ; NaN: not computed
  int num_solves = 0;                                                    // factorizations
  bool is_feasible = false;                                              // every loop closes
  bool is_minimum = false;  // projected gradient below 1e-10 and correct inertia (or least_norm was requested)
};

/// Solves Eq. (1) on one network, for one vector of lengths after another. All functions throw Stopped, and
/// FactorizationFailed at a zero pivot.
class InnerProblem {
 public:
  /// stop: checked before each factorization and before each step with closed loops.
  InnerProblem(const WireNetwork& network, NodeWeight node_weight, StopToken stop = {})
      : eq1_(network, node_weight), kkt_(eq1_, network, std::move(stop)) {}

  /// Returns the local minimum of Eq. (1) reached from the surface angles (Inner::minimum), or the first point where
  /// all loops close (Inner::least_norm). lengths: positive, scene units, #wire edges.
  InnerSolution solve(const Eigen::VectorXd& lengths, Inner inner);

  /// Returns the local minimum of Eq. (1) for these lengths on the branch of `from`, a solution for other lengths. This
  /// takes few factorizations.
  InnerSolution follow(const InnerSolution& from, const Eigen::VectorXd& lengths);

  /// Factors the optimality system at a minimum. Afterwards, change_of_headings() and total_derivative() take one solve
  /// each.
  void linearize(const InnerSolution& solution, const Eigen::VectorXd& lengths);

  /// Returns the change of φ, #wire edges, caused by a change of lengths along the minima of Eq. (1).
  Eigen::VectorXd change_of_headings(const InnerSolution& solution, const Eigen::VectorXd& change_of_lengths) const;

  /// Returns dE/dl of a function E(φ, l) if φ follows the lengths along the minima of Eq. (1). by_headings, by_lengths:
  /// ∂E/∂φ and ∂E/∂l at the solution, #wire edges each.
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
