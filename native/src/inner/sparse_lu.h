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
  std::size_t fill() const { return row_of_entry_.size(); }

 private:
  using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  void order(const Columns& a);
  void analyze(const Matrix& a, const Columns& a_by_columns);
  void factor(const Matrix& a, const Columns& a_by_columns);
  void substitute(const std::vector<double>& lower, const std::vector<double>& upper, Positions2& b) const;

  int size_;
  std::vector<int> row_of_pivot_;          // P: pivot k is row and column row_of_pivot_[k] of A
  std::vector<int> pivot_of_row_;          // its inverse
  std::vector<int> parent_;                // elimination tree of P (A + Aᵀ) Pᵀ, -1 at a root
  std::vector<std::size_t> column_start_;  // column j of L and row j of U: entries column_start_[j] to [j + 1]
  std::vector<int> row_of_entry_;          // row in L, column in U; ascending along each column of L
  std::vector<double> lower_;              // L
  std::vector<double> upper_;              // U
  std::vector<double> diagonal_;           // D
};

}  // namespace wirewarp
