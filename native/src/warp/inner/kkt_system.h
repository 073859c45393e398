// SPDX-License-Identifier: GPL-3.0-or-later
// The optimality system of a step of Eq. (1):
//
//   [ L + D   Jᵀ ] [ d ]   [ r₁ ]       L  Laplacian of the angles, D diagonal, J closure Jacobian
//   [ J      −δ  ] [ λ ] = [ r₂ ]       δ  diagonal, 1e-13 of J diag(L)⁻¹ Jᵀ, for linearly dependent closures
//
// The matrix is factored as LDLᵀ without pivoting, in the order of elimination_order.h. An extra diagonal entry at one
// edge fixes the rotation of the whole piece.
#pragma once

#include <Eigen/SparseCholesky>

#include "base/stop_token.h"
#include "warp/inner/eq1.h"

namespace wirewarp {

class KktSystem {
 public:
  /// stop: checked before each factorization.
  KktSystem(const Eq1& eq1, const WireNetwork& network, StopToken stop = {});

  /// Factors the matrix. Returns false if L + D is not positive definite on the null space of J (wrong inertia). The
  /// step may then go uphill.
  bool factor(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& diagonal,
              const Eigen::SparseMatrix<double>& jacobian);

  struct Solution {
    Eigen::VectorXd step;         // d, #edges
    Eigen::VectorXd multipliers;  // λ, #closures
  };
  /// Throws FactorizationFailed if the last factorization broke down on a zero pivot.
  Solution solve(const Eigen::VectorXd& r1, const Eigen::VectorXd& r2) const;

  const StopToken& stop() const { return stop_; }

  int num_factorizations() const { return num_factorizations_; }

 private:
  int num_edges_;
  int num_closures_;
  StopToken stop_;
  int num_factorizations_ = 0;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_;  // unknown -> position in the elimination order
  Eigen::SparseMatrix<double> matrix_;  // upper triangle in elimination order, without δ
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>> factor_;
};

}  // namespace wirewarp
