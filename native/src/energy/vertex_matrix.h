// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetric matrix with a 2 by 2 block for each vertex and for each pair of coupled vertices: the Hessian of a
// function of planar positions. Unknowns 2v and 2v+1 are x and y of vertex v. The pattern is fixed, so that terms look
// up their blocks once and write without searching.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "numerics/cholesky/matrix_graph.h"
#include "wirewarp/types.h"

namespace wirewarp {

class VertexMatrix {
 public:
  /// Where the two columns of a block begin among the values.
  struct Block {
    int left, right;
  };

  /// pairs: coupled vertices, in any order, repeated or not. A vertex may be paired with itself.
  VertexMatrix(int num_vertices, const std::vector<VertexPair>& pairs);

  /// The block of a coupled pair. row > column.
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

  /// m: symmetric.
  void add_diagonal(int vertex, const Eigen::Matrix2d& m) {
    double* value = lower_.valuePtr();
    value[diagonal_[static_cast<std::size_t>(vertex)].left] += m(0, 0);
    value[diagonal_[static_cast<std::size_t>(vertex)].left + 1] += m(1, 0);
    value[diagonal_[static_cast<std::size_t>(vertex)].right] += m(1, 1);
  }

  /// Larger of the two diagonal entries of a vertex.
  double largest_diagonal(int vertex) const;

  /// Which vertices are coupled.
  Graph graph() const { return graph_of(lower_, 2); }

  /// The lower triangle, diagonal included.
  const Eigen::SparseMatrix<double>& lower() const { return lower_; }

 private:
  Eigen::SparseMatrix<double> lower_;
  std::vector<Block> diagonal_;
};

}  // namespace wirewarp
