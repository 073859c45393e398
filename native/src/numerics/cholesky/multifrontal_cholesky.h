// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse Cholesky factorization A = L Lᵀ by the multifrontal method (J. W. H. Liu, The multifrontal method for sparse
// matrix solution: theory and practice, SIAM Review 34, 1992).
//
//   supernode   a node of the dissection tree; its unknowns are eliminated together
//   front       dense matrix of a supernode: its pivots, and the rows below that they reach in the factor
//
//     F = [ A₁₁  ·  ]  + Σ children's S     A₁₁ = L₁₁ L₁₁ᵀ,   L₂₁ = A₂₁ L₁₁⁻ᵀ,   S = F₂₂ − L₂₁ L₂₁ᵀ
//         [ A₂₁  F₂₂]
//
// S, the Schur complement, is what the front leaves to its parent's. L₁₁ and L₂₁ are the supernode's part of L.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "base/stop_token.h"
#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/front_layout.h"
#include "numerics/cholesky/nested_dissection.h"
#include "numerics/cholesky/substitution.h"

namespace wirewarp {

class MultifrontalCholesky {
 public:
  /// Analyzes a pattern and takes all the memory that factorize needs. lower: the lower triangle, compressed. Unknowns
  /// k v to k v + k - 1 belong to vertex v of the tree's graph, k = unknowns_per_vertex.
  /// in_threads: two threads work on independent subtrees; factor and solutions are the same to the last bit.
  /// keeps_root: the unknowns of the tree's last node are not eliminated (schur_complement()).
  /// Throws std::invalid_argument if the tree has not each vertex once or does not separate what lower joins.
  MultifrontalCholesky(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree, int unknowns_per_vertex,
                       bool in_threads = false, const FrontKernels& kernels = fastest_kernels(),
                       bool keeps_root = false);
  MultifrontalCholesky(const MultifrontalCholesky&) = delete;  // substitution_ refers to layout_
  MultifrontalCholesky& operator=(const MultifrontalCholesky&) = delete;

  /// New values on the same pattern. False if the matrix is not positive definite, a pivot not being a positive finite
  /// number, or if the caller stops; then there is no factor to solve with. Throws std::invalid_argument at a different
  /// number of entries.
  [[nodiscard]] bool factorize(const Eigen::SparseMatrix<double>& lower, const StopToken& stop = {});

  /// What elimination of all other unknowns leaves of A for those of the kept root. Substitution takes b there to its
  /// right-hand side on the way forward, and needs its solution there on the way back.
  Eigen::MatrixXd schur_complement() const;

  /// b := A⁻¹ b, right-hand sides in columns, four at a time. Throws std::logic_error without a factor.
  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> b) const;

  /// Fronts that substitution visits.
  FrontSet fronts_reaching(const std::vector<int>& vertices) const { return substitution_.fronts_reaching(vertices); }
  FrontSet others(const FrontSet& fronts) const { return substitution_.others(fronts); }
  const FrontSet& all() const { return substitution_.all(); }

  /// The two halves of a solution, for parts of b and x. b := L⁻¹ b, where b is zero but at pivots of some fronts.
  void substitute_forward(Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& nonzero) const;
  /// b := L⁻ᵀ b at pivots of the wanted fronts, whose ancestors are among them or have been visited before.
  void substitute_back(Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& wanted) const;

 private:
  FrontLayout layout_;
  Substitution substitution_;
  const FrontKernels* kernels_;
  bool in_threads_;
  std::unique_ptr<Tile[]> factor_;
  std::unique_ptr<Tile[]> schurs_;
  bool positive_definite_ = false;
};

}  // namespace wirewarp
