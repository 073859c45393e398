// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse LU without pivoting, for row-diagonally-dominant M-matrices: positive diagonal, no positive entry off it, no
// negative row sum. Elimination keeps these properties, so every pivot is positive and none needs to be exchanged.
//
//   P A Pᵀ = L D U    P a fill-reducing permutation, L and Uᵀ unit lower triangular, D diagonal
//
// Without pivoting the pattern of L is that of the Cholesky factor of A + Aᵀ, and Uᵀ has the same pattern: one array of
// row indices serves both.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

class SparseLu {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

  /// Factors a square matrix. Throws std::domain_error at a pivot that is not positive: then a is singular or no
  /// row-diagonally-dominant M-matrix.
  explicit SparseLu(const Matrix& a);

  /// b := A⁻¹ b. b has one row per row of A; both columns are solved in one sweep.
  void solve(Positions2& b) const;

  /// b := A⁻ᵀ b.
  void solve_transposed(Positions2& b) const;

  /// Entries of L below its diagonal.
  std::size_t fill() const { return fill_; }

 private:
  using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  /// Where the pivots, the rows and the entries of a supernode begin; they end where the next one's begin. A supernode
  /// is a run of pivots whose columns of L have the same rows below the run. Its rows are its own pivots, then those
  /// below; each row has an entry for each of its pivots.
  struct Supernode {
    int pivot;
    std::size_t row;
    std::size_t entry;
  };
  struct Analysis;

  int width(std::size_t s) const { return supernodes_[s + 1].pivot - supernodes_[s].pivot; }
  int height(std::size_t s) const { return static_cast<int>(supernodes_[s + 1].row - supernodes_[s].row); }

  void order(const Columns& a);
  Analysis analyze(const Matrix& a, const Columns& a_by_columns);
  void factor(const Matrix& a, const Columns& a_by_columns, const Analysis& analysis);
  void substitute(const std::vector<double>& lower, const std::vector<double>& upper, Positions2& b) const;

  int size_;
  std::size_t fill_ = 0;
  std::vector<int> row_of_pivot_;      // P: pivot k is row and column row_of_pivot_[k] of A
  std::vector<Supernode> supernodes_;  // and one past the last
  std::vector<int> rows_;              // of all supernodes, ascending in each
  std::vector<double> lower_;          // L, row by row of each supernode; 0 on and above the diagonal
  std::vector<double> upper_;          // Uᵀ, the same
  std::vector<double> diagonal_;       // D
};

}  // namespace wirewarp
