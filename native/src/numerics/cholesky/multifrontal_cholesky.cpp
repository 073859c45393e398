// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/multifrontal_cholesky.h"

#include <stdexcept>

#include "numerics/cholesky/eliminate_fronts.h"

namespace wirewarp {

MultifrontalCholesky::MultifrontalCholesky(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree,
                                           int unknowns_per_vertex, bool in_threads, const FrontKernels& kernels,
                                           bool keeps_root)
    : layout_(lay_out_fronts(lower, tree, unknowns_per_vertex, keeps_root)),
      substitution_(layout_, in_threads, kernels),
      kernels_(&kernels),
      in_threads_(in_threads),
      factor_(new Tile[layout_.panel_tiles]),
      schurs_(new Tile[layout_.schur_tiles]) {}

bool MultifrontalCholesky::factorize(const Eigen::SparseMatrix<double>& lower, const StopToken& stop) {
  if (lower.rows() != layout_.num_unknowns || static_cast<std::size_t>(lower.nonZeros()) != layout_.entries.size()) {
    throw std::invalid_argument("multifrontal Cholesky: the matrix must have the pattern that was analyzed");
  }
  positive_definite_ = eliminate_fronts(layout_, in_threads_, stop, [&](int f) {
    const Front& front = layout_.fronts[f];
    assemble_front(layout_, f, lower.valuePtr(), factor_.get(), schurs_.get());
    return kernels_->factor(&factor_[front.panel], &schurs_[front.schur], front.pivot_tiles, front.row_tiles);
  });
  const int root = layout_.kept_root;
  if (positive_definite_ && root != -1) assemble_front(layout_, root, lower.valuePtr(), factor_.get(), schurs_.get());
  return positive_definite_;
}

Eigen::MatrixXd MultifrontalCholesky::schur_complement() const {
  if (layout_.kept_root == -1) return {};
  const Front& root = layout_.fronts[layout_.kept_root];
  const int size = layout_.unknowns_per_vertex * root.num_pivots;
  Eigen::MatrixXd schur(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Tile& tile = factor_[root.panel + panel_row(i / kTile, root.pivot_tiles) + j / kTile];
      schur(i, j) = schur(j, i) = tile.entries[kTile * (j % kTile) + i % kTile];
    }
  }
  return schur;
}

void MultifrontalCholesky::solve_in_place(Eigen::Ref<Eigen::MatrixXd> b) const {
  substitute_forward(b, all());
  substitute_back(b, all());
}

void MultifrontalCholesky::substitute_forward(Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& nonzero) const {
  if (!positive_definite_) throw std::logic_error("multifrontal Cholesky: there is no factor to solve with");
  substitution_.forward(factor_.get(), b, nonzero);
}

void MultifrontalCholesky::substitute_back(Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& wanted) const {
  if (!positive_definite_) throw std::logic_error("multifrontal Cholesky: there is no factor to solve with");
  substitution_.back(factor_.get(), b, wanted);
}

}  // namespace wirewarp
