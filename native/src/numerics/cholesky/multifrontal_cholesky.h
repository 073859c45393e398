// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse Cholesky factorization A = L Lᵀ by the multifrontal method (J. W. H. Liu, The multifrontal method for sparse
// matrix solution: theory and practice, SIAM Review 34, 1992).
//
//   supernode   a node of the dissection tree; its unknowns are eliminated together
//   front       dense matrix of a supernode: its pivots, and the rows below with nonzeros in the factor
//
//     F = [ A₁₁  ·  ]  + Σ children's S     A₁₁ = L₁₁ L₁₁ᵀ,   L₂₁ = A₂₁ L₁₁⁻ᵀ,   S = F₂₂ − L₂₁ L₂₁ᵀ
//         [ A₂₁  F₂₂]
//
// The Schur complement S is added to the parent's front. L₁₁ and L₂₁ are the supernode's part of L.
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
  /// Analyzes a pattern and allocates all memory that factorize needs. Throws std::invalid_argument if the tree does
  /// not contain each vertex once or does not separate coupled vertices.
  ///
  /// lower: the lower triangle, compressed
  /// unknowns_per_vertex: k; unknowns k v to k v + k - 1 belong to vertex v of the tree's graph
  /// in_threads: whether two threads are used, which does not change any bit of the results
  /// keeps_root: whether the tree's last node is not eliminated, see schur_complement()
  MultifrontalCholesky(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree, int unknowns_per_vertex,
                       bool in_threads = false, const FrontKernels& kernels = fastest_kernels(),
                       bool keeps_root = false);
  MultifrontalCholesky(const MultifrontalCholesky&) = delete;  // not copied: substitution_ refers to layout_
  MultifrontalCholesky& operator=(const MultifrontalCholesky&) = delete;

  /// Factors new values on the same pattern. Returns false, without a factor, if a pivot is not a positive finite
  /// number or the caller stops. Throws std::invalid_argument if the number of entries differs.
  [[nodiscard]] bool factorize(const Eigen::SparseMatrix<double>& lower, const StopToken& stop = {});

  /// Returns the Schur complement of A for the unknowns of the kept root. At these unknowns, forward substitution
  /// returns the right-hand side of the reduced system, and back substitution expects its solution.
  Eigen::MatrixXd schur_complement() const;

  /// Replaces b by A⁻¹ b. The columns of b are right-hand sides, of which four are solved at a time. Throws
  /// std::logic_error without a factor.
  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> b) const;

  /// These functions return sets of fronts for the substitutions below (see substitution.h).
  FrontSet fronts_reaching(const std::vector<int>& vertices) const { return substitution_.fronts_reaching(vertices); }
  FrontSet others(const FrontSet& fronts) const { return substitution_.others(fronts); }
  const FrontSet& all() const { return substitution_.all(); }

  /// First half of a solution: replaces b by L⁻¹ b. b must be zero except at pivots of the given fronts.
  void substitute_forward(Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& nonzero) const;
  /// Second half: replaces b by L⁻ᵀ b at pivots of the wanted fronts. If the set does not include all ancestors of
  /// these fronts, an earlier call must have solved for the ancestors.
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
