// SPDX-License-Identifier: GPL-3.0-or-later
// Up-looking elimination: step k computes row k of L, column k of U and the pivot between them from all earlier ones.
// Indices are those of P A Pᵀ, j < i <= k:
//
//   l_kj, u_jk   row k of L, column k of U; 1 on the diagonals
//   d_k          pivot k
//   y_j, z_j     a_kj and a_jk less what pivots before j eliminate from them; at the end y_j = l_kj d_j, z_j = d_j u_jk
//
//   y_i -= Σ y_j u_ji,   z_i -= Σ l_ij z_j,   d_k = a_kk - Σ y_j z_j / d_j
//
// The j that take part in step k are those on the paths of the elimination tree from the entries of row and column k
// of A up to k (T. A. Davis, Direct Methods for Sparse Linear Systems, SIAM 2006, chapter 4). Of a supernode all pivots
// take part or none: the sums run over a whole supernode, and its rows are walked once instead of once per pivot.
#include "inner/sparse_lu.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace wirewarp {

/// What the factorization knows before it meets a number, besides the size of each supernode.
struct SparseLu::Analysis {
  std::vector<int> pivot_of_row;  // Pᵀ
  std::vector<int> supernode_of_pivot;
  std::vector<int> parent;  // of each supernode in the elimination tree, -1 at a root
};

namespace {

using ConstVector = Eigen::Map<const Eigen::VectorXd>;

/// The nodes of a tree met on the way up from several nodes to one that they all descend from.
class Reach {
 public:
  explicit Reach(const std::vector<int>& parent)
      : parent_(parent), step_of_(parent.size(), -1), nodes_(parent.size()), path_(parent.size()) {}

  void start(int step, int top) {
    step_ = step;
    first_ = nodes_.size();
    step_of_[top] = step;
    nodes_[--first_] = top;
  }
  void climb_from(int node) {
    std::size_t length = 0;
    for (; step_of_[node] != step_; node = parent_[node]) {
      step_of_[node] = step_;
      path_[length++] = node;
    }
    while (length > 0) nodes_[--first_] = path_[--length];
  }
  /// From begin to end each node comes before its ancestors.
  auto begin() const { return nodes_.begin() + static_cast<std::ptrdiff_t>(first_); }
  auto end() const { return nodes_.end(); }

 private:
  const std::vector<int>& parent_;
  std::vector<int> step_of_;  // the last step that met a node
  std::vector<int> nodes_;    // filled from the back
  std::vector<int> path_;
  std::size_t first_ = 0;
  int step_ = -1;
};

}  // namespace

SparseLu::SparseLu(const Matrix& a) : size_(static_cast<int>(a.rows())) {
  const Columns a_by_columns = a;
  order(a_by_columns);
  factor(a, a_by_columns, analyze(a, a_by_columns));
}

/// P: approximate minimum degree on the pattern of A + Aᵀ.
void SparseLu::order(const Columns& a) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(a, order);
  row_of_pivot_.assign(order.indices().begin(), order.indices().end());
}

/// The elimination tree, the entries below the diagonal of each column of L, and from them the supernodes.
SparseLu::Analysis SparseLu::analyze(const Matrix& a, const Columns& a_by_columns) {
  std::vector<int> pivot_of_row(size_);
  for (int k = 0; k < size_; ++k) pivot_of_row[row_of_pivot_[k]] = k;
  std::vector<int> parent(size_, -1), count(size_, 0), step_of(size_, -1);
  const auto climb = [&](int i, int k) {
    for (; step_of[i] != k; i = parent[i]) {
      step_of[i] = k;
      ++count[i];
      if (parent[i] < 0) parent[i] = k;
    }
  };
  for (int k = 0; k < size_; ++k) {
    step_of[k] = k;
    const int row = row_of_pivot_[k];
    for (Matrix::InnerIterator it(a, row); it; ++it) {
      if (const int i = pivot_of_row[it.col()]; i < k) climb(i, k);
    }
    for (Columns::InnerIterator it(a_by_columns, row); it; ++it) {
      if (const int i = pivot_of_row[it.row()]; i < k) climb(i, k);
    }
  }

  Analysis analysis{std::move(pivot_of_row), std::vector<int>(size_), {}};
  Supernode next{0, 0, 0};
  for (int k = 0; k < size_; ++k) {
    fill_ += count[k];
    analysis.supernode_of_pivot[k] = static_cast<int>(supernodes_.size());
    if (parent[k] == k + 1 && count[k] == count[k + 1] + 1) continue;  // pivot k + 1 belongs to the same supernode
    supernodes_.push_back(next);
    analysis.parent.push_back(parent[k]);
    const std::size_t columns = k + 1 - next.pivot, rows = columns + count[k];
    next = {k + 1, next.row + rows, next.entry + rows * columns};
  }
  supernodes_.push_back(next);
  for (int& node : analysis.parent) {
    if (node >= 0) node = analysis.supernode_of_pivot[node];
  }
  return analysis;
}

void SparseLu::factor(const Matrix& a, const Columns& a_by_columns, const Analysis& analysis) {
  rows_.resize(supernodes_.back().row);
  lower_.resize(supernodes_.back().entry);
  upper_.resize(supernodes_.back().entry);
  diagonal_.resize(size_);
  std::vector<double> y(size_, 0.0), z(size_, 0.0);
  std::vector<int> filled_rows(analysis.parent.size(), 0);
  Reach reach(analysis.parent);

  for (int k = 0; k < size_; ++k) {
    reach.start(k, analysis.supernode_of_pivot[k]);
    const int row = row_of_pivot_[k];
    for (Matrix::InnerIterator it(a, row); it; ++it) {
      const int i = analysis.pivot_of_row[it.col()];
      if (i > k) continue;
      reach.climb_from(analysis.supernode_of_pivot[i]);
      y[i] = it.value();
    }
    for (Columns::InnerIterator it(a_by_columns, row); it; ++it) {
      const int i = analysis.pivot_of_row[it.row()];
      if (i >= k) continue;
      reach.climb_from(analysis.supernode_of_pivot[i]);
      z[i] = it.value();
    }

    double pivot = y[k];
    y[k] = 0;
    for (const int s : reach) {
      const Supernode& node = supernodes_[s];
      const int stride = width(s);
      const int row_k = filled_rows[s]++;
      const int columns = std::min(row_k, stride);  // fewer than all where k is a pivot of s itself
      double* lower = &lower_[node.entry];
      double* upper = &upper_[node.entry];
      double* y_s = &y[node.pivot];
      double* z_s = &z[node.pivot];
      for (int r = 1; r < row_k; ++r) {
        const int i = rows_[node.row + r];
        const int before_i = std::min(r, columns);
        const std::size_t entry = static_cast<std::size_t>(r) * stride;
        y[i] -= ConstVector(y_s, before_i).dot(ConstVector(upper + entry, before_i));
        z[i] -= ConstVector(z_s, before_i).dot(ConstVector(lower + entry, before_i));
      }
      rows_[node.row + row_k] = k;
      lower += static_cast<std::size_t>(row_k) * stride;
      upper += static_cast<std::size_t>(row_k) * stride;
      for (int j = 0; j < columns; ++j) {
        const double d = diagonal_[node.pivot + j];
        lower[j] = y_s[j] / d;
        upper[j] = z_s[j] / d;
        pivot -= y_s[j] * upper[j];
        y_s[j] = z_s[j] = 0;
      }
    }
    if (!(pivot > 0)) throw std::domain_error("SparseLu: pivot " + std::to_string(k) + " is not positive");
    diagonal_[k] = pivot;
  }
}

void SparseLu::solve(Positions2& b) const { substitute(lower_, upper_, b); }

/// Aᵀ = Pᵀ Uᵀ D Lᵀ P: the same sweeps with L and U exchanged.
void SparseLu::solve_transposed(Positions2& b) const { substitute(upper_, lower_, b); }

void SparseLu::substitute(const std::vector<double>& lower, const std::vector<double>& upper, Positions2& b) const {
  using Pair = Eigen::Array2d;  // x and y of a position
  std::vector<Pair> x(size_);
  for (int k = 0; k < size_; ++k) x[k] = b.row(row_of_pivot_[k]).transpose();
  const std::size_t num_supernodes = supernodes_.size() - 1;
  for (std::size_t s = 0; s < num_supernodes; ++s) {
    const Supernode& node = supernodes_[s];
    for (int r = 1; r < height(s); ++r) {
      const double* l = &lower[node.entry + static_cast<std::size_t>(r) * width(s)];
      Pair sum = Pair::Zero();
      for (int j = 0; j < std::min(r, width(s)); ++j) sum += l[j] * x[node.pivot + j];
      x[rows_[node.row + r]] -= sum;
    }
  }
  for (std::size_t s = num_supernodes; s-- > 0;) {
    const Supernode& node = supernodes_[s];
    for (int j = 0; j < width(s); ++j) x[node.pivot + j] /= diagonal_[node.pivot + j];
    for (int r = height(s) - 1; r > 0; --r) {
      const double* u = &upper[node.entry + static_cast<std::size_t>(r) * width(s)];
      const Pair x_r = x[rows_[node.row + r]];
      for (int j = 0; j < std::min(r, width(s)); ++j) x[node.pivot + j] -= u[j] * x_r;
    }
  }
  for (int k = 0; k < size_; ++k) b.row(row_of_pivot_[k]) = x[k].transpose();
}

}  // namespace wirewarp
