// SPDX-License-Identifier: GPL-3.0-or-later
// Up-looking elimination: step k computes row k of L, column k of U and the pivot between them from all earlier ones.
// Indices are those of P A Pᵀ, j < i <= k:
//
//   l_kj, u_jk   row k of L, column k of U; 1 on the diagonals
//   d_k          pivot k
//   y_j, z_j     a_kj and a_jk less what pivots before j eliminate from them; at the end y_j = l_kj d_j, z_j = d_j u_jk
//
//   y_i -= y_j u_ji,   z_i -= l_ij z_j   for every i in column j of L,   d_k = a_kk - Σ y_j z_j / d_j
//
// The j that take part in step k are the nodes of the elimination tree on the paths from the entries of row and column
// k of A up to k (T. A. Davis, Direct Methods for Sparse Linear Systems, SIAM 2006, chapter 4).
#include "inner/sparse_lu.h"

#include <Eigen/OrderingMethods>
#include <stdexcept>
#include <string>

namespace wirewarp {
namespace {

/// Two numbers worked on side by side: (y, z) of the elimination, (x, y) of a position.
using Pair = Eigen::Array2d;

}  // namespace

SparseLu::SparseLu(const Matrix& a) : size_(static_cast<int>(a.rows())) {
  const Columns a_by_columns = a;
  order(a_by_columns);
  analyze(a, a_by_columns);
  factor(a, a_by_columns);
}

/// P: approximate minimum degree on the pattern of A + Aᵀ.
void SparseLu::order(const Columns& a) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(a, order);
  row_of_pivot_.assign(order.indices().begin(), order.indices().end());
  pivot_of_row_.resize(row_of_pivot_.size());
  for (int k = 0; k < size_; ++k) pivot_of_row_[row_of_pivot_[k]] = k;
}

/// The elimination tree and the room each column of L needs.
void SparseLu::analyze(const Matrix& a, const Columns& a_by_columns) {
  parent_.assign(size_, -1);
  column_start_.assign(size_ + 1, 0);
  std::vector<int> visited_in_step(size_, -1);
  const auto climb = [&](int i, int k) {
    for (; visited_in_step[i] != k; i = parent_[i]) {
      visited_in_step[i] = k;
      ++column_start_[i + 1];
      if (parent_[i] < 0) parent_[i] = k;
    }
  };
  for (int k = 0; k < size_; ++k) {
    visited_in_step[k] = k;
    const int row = row_of_pivot_[k];
    for (Matrix::InnerIterator it(a, row); it; ++it)
      if (const int i = pivot_of_row_[it.col()]; i < k) climb(i, k);
    for (Columns::InnerIterator it(a_by_columns, row); it; ++it)
      if (const int i = pivot_of_row_[it.row()]; i < k) climb(i, k);
  }
  for (int k = 0; k < size_; ++k) column_start_[k + 1] += column_start_[k];
}

void SparseLu::factor(const Matrix& a, const Columns& a_by_columns) {
  row_of_entry_.resize(column_start_[size_]);
  lower_.resize(row_of_entry_.size());
  upper_.resize(row_of_entry_.size());
  diagonal_.resize(size_);
  std::vector<std::size_t> column_end(column_start_.begin(), column_start_.end() - 1);  // filled up to here
  std::vector<Pair> yz(size_, Pair::Zero());
  std::vector<int> visited_in_step(size_, -1), reach(size_), path(size_);

  for (int k = 0; k < size_; ++k) {
    // reach[first..]: the pivots of this step, each before its ancestors.
    int first = size_;
    visited_in_step[k] = k;
    const auto climb = [&](int i) {
      int length = 0;
      for (; visited_in_step[i] != k; i = parent_[i]) {
        visited_in_step[i] = k;
        path[length++] = i;
      }
      while (length > 0) reach[--first] = path[--length];
    };
    const int row = row_of_pivot_[k];
    for (Matrix::InnerIterator it(a, row); it; ++it) {
      const int i = pivot_of_row_[it.col()];
      if (i > k) continue;
      climb(i);
      yz[i][0] = it.value();
    }
    for (Columns::InnerIterator it(a_by_columns, row); it; ++it) {
      const int i = pivot_of_row_[it.row()];
      if (i >= k) continue;
      climb(i);
      yz[i][1] = it.value();
    }

    double pivot = yz[k][0];
    yz[k].setZero();
    for (int step = first; step < size_; ++step) {
      const int j = reach[step];
      const Pair yz_j = yz[j];
      yz[j].setZero();
      for (std::size_t p = column_start_[j]; p < column_end[j]; ++p)
        yz[row_of_entry_[p]] -= yz_j * Pair(upper_[p], lower_[p]);
      const Pair lu = yz_j / diagonal_[j];
      pivot -= yz_j[0] * lu[1];
      const std::size_t p = column_end[j]++;
      row_of_entry_[p] = k;
      lower_[p] = lu[0];
      upper_[p] = lu[1];
    }
    if (!(pivot > 0)) throw std::domain_error("SparseLu: pivot " + std::to_string(k) + " is not positive");
    diagonal_[k] = pivot;
  }
}

void SparseLu::solve(Positions2& b) const {
  substitute(lower_, upper_, b);
}

/// Aᵀ = Pᵀ Uᵀ D Lᵀ P: the same sweeps with L and U exchanged.
void SparseLu::solve_transposed(Positions2& b) const {
  substitute(upper_, lower_, b);
}

void SparseLu::substitute(const std::vector<double>& lower, const std::vector<double>& upper, Positions2& b) const {
  std::vector<Pair> x(size_);
  for (int k = 0; k < size_; ++k) x[k] = b.row(row_of_pivot_[k]).transpose();
  for (int j = 0; j < size_; ++j)
    for (std::size_t p = column_start_[j]; p < column_start_[j + 1]; ++p) x[row_of_entry_[p]] -= lower[p] * x[j];
  for (int j = size_ - 1; j >= 0; --j) {
    x[j] /= diagonal_[j];
    for (std::size_t p = column_start_[j]; p < column_start_[j + 1]; ++p) x[j] -= upper[p] * x[row_of_entry_[p]];
  }
  for (int k = 0; k < size_; ++k) b.row(row_of_pivot_[k]) = x[k].transpose();
}

}  // namespace wirewarp
