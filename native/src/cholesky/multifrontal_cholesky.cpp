// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholesky/multifrontal_cholesky.h"

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "cholesky/run_shares.h"
#include "index.h"

namespace wirewarp {
namespace {

double& entry(Tile& tile, int row, int column) { return tile.entries[kTile * column + row]; }

/// How many rows from row i on, of one tile, go to as many successive rows of one tile: 4, 2 or 1.
int rows_alike(const int* target, int i, int num_rows) {
  for (const int run : {4, 2}) {
    if (i % run == 0 && i + run <= num_rows && target[i] % run == 0 && target[i + run - 1] == target[i] + run - 1) {
      return run;
    }
  }
  return 1;
}

/// Adds columns begin to end of kRows rows to columns target[begin] to target[end - 1]. Rows of a tile are 4 apart.
template <int kRows>
void add_rows(const double* from, const int* target, int begin, int end, double* to) {
  for (int j = begin; j < end; ++j) {
    for (int i = 0; i < kRows; ++i) to[kTile * target[j] + i] += from[kTile * j + i];
  }
}

void add_rows(int num_rows, const double* from, const int* target, int begin, int end, double* to) {
  const auto add = num_rows == 4 ? add_rows<4> : num_rows == 2 ? add_rows<2> : add_rows<1>;
  add(from, target, begin, end, to);
}

}  // namespace

bool has_second_core() { return std::thread::hardware_concurrency() > 1; }

MultifrontalCholesky::MultifrontalCholesky(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree,
                                           int unknowns_per_vertex, bool in_threads, const FrontKernels& kernels)
    : layout_(lay_out_fronts(lower, tree, unknowns_per_vertex)),
      all_(branches_where(std::vector<char>(layout_.fronts.size(), 1))),
      kernels_(&kernels),
      in_threads_(in_threads),
      factor_(new Tile[layout_.panel_tiles]),
      schur_(new Tile[layout_.schur_tiles]) {}

bool MultifrontalCholesky::factorize(const Eigen::SparseMatrix<double>& lower) {
  if (lower.rows() != layout_.num_unknowns || at(static_cast<int>(lower.nonZeros())) != layout_.entries.size()) {
    throw std::invalid_argument("multifrontal Cholesky: the matrix has another pattern");
  }
  positive_definite_ = true;
  const auto eliminate_all = [&](const std::vector<int>& fronts) {
    for (int f : fronts) {
      if (positive_definite_) eliminate(f, lower.valuePtr());
    }
  };
  run_shares(layout_.shares.size(), in_threads_, [&](std::size_t share) { eliminate_all(layout_.shares[share]); });
  eliminate_all(layout_.last_fronts);
  return positive_definite_;
}

/// Assembles a front from the matrix and its children, and factors it.
void MultifrontalCholesky::eliminate(int node, const double* values) {
  const Front* const front = &layout_.fronts[at(node)];
  const int m = front->pivot_tiles, r = front->row_tiles;
  Tile* const panel = factor_.get() + front->panel;
  Tile* const schur = schur_.get() + front->schur;
  std::fill_n(panel, panel_row(m + r, m), Tile{});
  std::fill_n(schur, triangle_size(r), Tile{});
  for (int i = layout_.unknowns_per_vertex * front->num_pivots; i < kTile * m; ++i) {
    entry(panel[panel_row(m - 1, m) + at(m - 1)], i % kTile, i % kTile) = 1;
  }
  for (int e = front[0].first_entry; e < front[1].first_entry; ++e) {
    const MatrixEntry& from = layout_.entries[at(e)];
    panel[from.place / 16].entries[from.place % 16] += values[from.source];
  }
  for (int c = front[0].first_child; c < front[1].first_child; ++c) add_child(layout_.children[at(c)], node);
  if (!kernels_->factor(panel, schur, m, r)) positive_definite_ = false;
}

/// Extend-add: each entry of the child's Schur complement to its place in the parent's front.
void MultifrontalCholesky::add_child(int child, int node) {
  const Front& from = layout_.fronts[at(child)];
  const Front& to = layout_.fronts[at(node)];
  const int m = to.pivot_tiles;
  const int num_rows = layout_.unknowns_per_vertex * from.num_rows;
  const int* const rows = layout_.rows_in_parent.data() + from.first_row;
  const int num_pivots = static_cast<int>(std::lower_bound(rows, rows + num_rows, kTile * m) - rows);
  for (int i = 0; i < num_rows;) {
    const int run = rows_alike(rows, i, num_rows);
    const int t = rows[i] / kTile;
    const double* const source = schur_[from.schur + triangle_size(i / kTile)].entries + i % kTile;
    double* const panel = factor_[to.panel + panel_row(t, m)].entries + rows[i] % kTile;
    add_rows(run, source, rows, 0, std::min(i + run, num_pivots), panel);
    if (t >= m) {
      double* const schur = schur_[to.schur + triangle_size(t - m)].entries + rows[i] % kTile - kTile * kTile * m;
      add_rows(run, source, rows, num_pivots, i + run, schur);
    }
    i += run;
  }
}

}  // namespace wirewarp
