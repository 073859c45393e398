// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/multifrontal_lu.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/factorization_failed.h"
#include "numerics/cholesky/eliminate_fronts.h"
#include "numerics/cholesky/matrix_graph.h"
#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

bool have_same_pattern(const SparseMatrix& a, const SparseMatrix& b) {
  return a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace

/// The entries of A that belong to L, and the transposed entries of U. An entry belongs to L if its row is eliminated
/// after its column. `lower` and `upper` have the pattern of A's lower triangle.
struct MultifrontalLu::Triangles {
  Triangles(const Matrix& a, const Positions2& positions)
      : lower(a.triangularView<Eigen::Lower>()),
        upper(a.transpose().triangularView<Eigen::Lower>()),
        tree(nested_dissection(graph_of(lower, 1), positions)) {
    if (!have_same_pattern(lower, upper)) throw std::invalid_argument("multifrontal LU: the pattern is not symmetric");
    std::vector<int> place(lower.rows());
    int count = 0;
    for (const DissectionTree::Node& node : tree.nodes) {
      for (int v : node.vertices) place[v] = count++;
    }
    for (int column = 0; column < lower.outerSize(); ++column) {
      for (int i = lower.outerIndexPtr()[column]; i < lower.outerIndexPtr()[column + 1]; ++i) {
        const bool is_lower = place[lower.innerIndexPtr()[i]] >= place[column];
        if (!is_lower) std::swap(lower.valuePtr()[i], upper.valuePtr()[i]);
      }
    }
  }

  SparseMatrix lower, upper;
  DissectionTree tree;
};

MultifrontalLu::MultifrontalLu(const Matrix& a, const Positions2& positions, bool in_threads, const StopToken& stop,
                               const FrontKernels& kernels)
    : MultifrontalLu(Triangles(a, positions), in_threads, stop, kernels) {}

MultifrontalLu::MultifrontalLu(const Triangles& a, bool in_threads, const StopToken& stop, const FrontKernels& kernels)
    : layout_(lay_out_fronts(a.lower, a.tree, 1)),
      substitution_(layout_, in_threads, kernels),
      lower_(new Tile[layout_.panel_tiles]),
      upper_(new Tile[layout_.panel_tiles]) {
  stop.check();
  const Tiles lower_schurs(new Tile[layout_.schur_tiles]);
  const Tiles upper_schurs(new Tile[layout_.schur_tiles]);
  const bool is_factored = eliminate_fronts(layout_, in_threads, stop, [&](int f) {
    const Front& front = layout_.fronts[f];
    assemble_front(layout_, f, a.lower.valuePtr(), lower_.get(), lower_schurs.get());
    assemble_front(layout_, f, a.upper.valuePtr(), upper_.get(), upper_schurs.get());
    return kernels.factor_lu(&lower_[front.panel], &lower_schurs[front.schur], &upper_[front.panel],
                             &upper_schurs[front.schur], front.pivot_tiles, front.row_tiles);
  });
  stop.check();
  if (!is_factored) throw FactorizationFailed("multifrontal LU: a pivot is not positive");
}

void MultifrontalLu::substitute(const Tiles& forward, const Tiles& back, Positions2& b) const {
  Eigen::MatrixXd x = b;
  substitution_.forward(forward.get(), x, substitution_.all());
  substitution_.back(back.get(), x, substitution_.all());
  b = x;
}

}  // namespace wirewarp
