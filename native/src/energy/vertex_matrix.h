// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetric matrix with a 2 by 2 block for each vertex and for each pair of coupled vertices: the Hessian of a
// function of planar positions. Unknowns 2v and 2v+1 are x and y of vertex v. The pattern is fixed, so each term of the
// function looks up its blocks once and then writes without searching.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "numerics/cholesky/matrix_graph.h"
#include "wirewarp/types.h"

namespace wirewarp {

class VertexMatrix {
 public:
  /// Indices of the values at which the block's two columns begin.
  struct Block {
    int left, right;
  };

  /// pairs: coupled vertices in any order; repetitions and pairs of a vertex with itself are allowed.
  VertexMatrix(int num_vertices, const std::vector<VertexPair>& pairs);

  /// Returns the block of a coupled pair. Needs row > column.
  Block block(int row, int column) const;

  void set_zero() { lower_.coeffs().setZero(); }
  void set_values(const Eigen::ArrayXd& values) { lower_.coeffs() = values; }
  Eigen::ArrayXd values() const { return lower_.coeffs(); }

  void add(Block block, const Eigen::Matrix2d& m) {
    double* value = lower_.valuePtr();
    value[block.left] += m(0, 0);
    value[block.left + 1] += m(1, 0);
    value[block.right] += m(0, 1);
    value[block.right + 1] += m(1, 1);
  }

  /// Adds m, which must be symmetric, to the diagonal block of a vertex.
  void add_diagonal(int vertex, const Eigen::Matrix2d& m) {
    double* value = lower_.valuePtr();
    value[diagonal_[static_cast<std::size_t>(vertex)].left] += m(0, 0);
    value[diagonal_[static_cast<std::size_t>(vertex)].left + 1] += m(1, 0);
    value[diagonal_[static_cast<std::size_t>(vertex)].right] += m(1, 1);
  }

  double largest_diagonal(int vertex) const;

  Graph graph() const { return graph_of(lower_, 2); }

  /// Returns the lower triangle, including the diagonal.
  const Eigen::SparseMatrix<double>& lower() const { return lower_; }

 private:
  Eigen::SparseMatrix<double> lower_;
  std::vector<Block> diagonal_;
};

}  // namespace wirewarp
