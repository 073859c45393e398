// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse factorization A = L U by the multifrontal method, without pivoting, for row-diagonally-dominant M-matrices:
// aᵢᵢ > 0, aᵢⱼ <= 0 and Σⱼ aᵢⱼ >= 0. Elimination keeps these properties, so every pivot is positive and no pivoting is
// needed. L and Uᵀ have the pattern of a Cholesky factor. The fronts are those of multifrontal_cholesky.h, each with a
// panel for L and a panel for Uᵀ.
#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "base/stop_token.h"
#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/front_layout.h"
#include "numerics/cholesky/substitution.h"
#include "wirewarp/types.h"

namespace wirewarp {

class MultifrontalLu {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// Factors a square matrix with a symmetric pattern. positions: one per row. Throws Stopped, std::invalid_argument
  /// for other patterns, and FactorizationFailed at a pivot that is not a positive finite number.
  MultifrontalLu(const Matrix& a, const Positions2& positions, bool in_threads = false, const StopToken& stop = {},
                 const FrontKernels& kernels = fastest_kernels());
  MultifrontalLu(const MultifrontalLu&) = delete;  // not copied: substitution_ refers to layout_
  MultifrontalLu& operator=(const MultifrontalLu&) = delete;

  /// Replaces b by A⁻¹ b. b: one row per row of A. Both columns of b are solved in one sweep.
  void solve(Positions2& b) const { substitute(lower_, upper_, b); }

  /// Replaces b by A⁻ᵀ b, with Aᵀ = Uᵀ Lᵀ.
  void solve_transposed(Positions2& b) const { substitute(upper_, lower_, b); }

 private:
  using Tiles = std::unique_ptr<Tile[]>;

  struct Triangles;

  MultifrontalLu(const Triangles& a, bool in_threads, const StopToken& stop, const FrontKernels& kernels);
  void substitute(const Tiles& forward, const Tiles& back, Positions2& b) const;

  FrontLayout layout_;
  Substitution substitution_;
  Tiles lower_;  // panels of L
  Tiles upper_;  // panels of Uᵀ
};

}  // namespace wirewarp
