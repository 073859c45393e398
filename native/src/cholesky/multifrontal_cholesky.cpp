// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholesky/multifrontal_cholesky.h"

#include <algorithm>
#include <future>
#include <stdexcept>
#include <thread>

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

int num_factor_threads() { return std::thread::hardware_concurrency() > 1 ? 2 : 1; }

struct MultifrontalCholesky::Workspace {
  explicit Workspace(int num_tiles) : x(new Tile[at(num_tiles)]), sums(new Tile[at(num_tiles)]) {}
  std::unique_ptr<Tile[]> x;     // right-hand sides in the rows of a front, kColumns of them side by side
  std::unique_ptr<Tile[]> sums;  // what the kernels need
};

MultifrontalCholesky::MultifrontalCholesky(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree,
                                           int unknowns_per_vertex, int num_threads, const FrontKernels& kernels)
    : layout_(lay_out_fronts(lower, tree, unknowns_per_vertex, num_threads)),
      kernels_(&kernels),
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
  std::vector<std::future<void>> others;
  for (std::size_t thread = 1; thread < layout_.fronts_of_thread.size(); ++thread) {
    others.push_back(std::async(std::launch::async, eliminate_all, std::cref(layout_.fronts_of_thread[thread])));
  }
  eliminate_all(layout_.fronts_of_thread[0]);
  for (std::future<void>& other : others) other.get();
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

void MultifrontalCholesky::solve_in_place(Eigen::Ref<Eigen::MatrixXd> b) const {
  Branches all(layout_.fronts.size() - 1);
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<int>(f);
  solve_in_place(b, all, all);
}

void MultifrontalCholesky::solve_in_place(Eigen::Ref<Eigen::MatrixXd> b, const Branches& nonzero,
                                          const Branches& wanted) const {
  if (!positive_definite_) throw std::logic_error("multifrontal Cholesky: there is no factor to solve with");
  if (b.rows() != layout_.num_unknowns) throw std::invalid_argument("multifrontal Cholesky: b has another size");
  Workspace space(layout_.largest_front);
  for (Eigen::Index first = 0; first < b.cols(); first += kTile) {
    const Eigen::Index columns = std::min<Eigen::Index>(kTile, b.cols() - first);
    const auto solve = columns == 1 ? &MultifrontalCholesky::substitute<1> : &MultifrontalCholesky::substitute<kTile>;
    (this->*solve)(b.middleCols(first, columns), nonzero, wanted, space);
  }
}

/// For one or up to four columns: L⁻¹ b, then L⁻ᵀ of that, front by front.
template <int kColumns>
void MultifrontalCholesky::substitute(Eigen::Ref<Eigen::MatrixXd> b, const Branches& nonzero, const Branches& wanted,
                                      Workspace& space) const {
  const int k = layout_.unknowns_per_vertex;
  const int columns = kColumns == 1 ? 1 : static_cast<int>(b.cols());
  double* const x = space.x[0].entries;
  const auto for_each_row = [&](const Front& front, int num_vertices, auto&& function) {
    const int* const vertices = layout_.vertices.data() + front.first_vertex;
    for (int place = 0; place < num_vertices; ++place) {
      double* const in_front = x + kColumns * layout_.row_of(front, place);
      double* const in_b = b.data() + k * vertices[place];
      for (int i = 0; i < k; ++i) {
        for (int c = 0; c < columns; ++c) function(in_front[kColumns * i + c], in_b[i + c * b.outerStride()]);
      }
    }
  };
  const auto gather = [&](const Front& front) {
    std::fill_n(x, kColumns * kTile * (front.pivot_tiles + front.row_tiles), 0.0);
    for_each_row(front, front.num_pivots + front.num_rows, [](double& in_front, double& in_b) { in_front = in_b; });
  };
  const auto scatter = [&](const Front& front, int num_vertices) {
    for_each_row(front, num_vertices, [](double& in_front, double& in_b) { in_b = in_front; });
  };
  for (int f : nonzero) {
    const Front& front = layout_.fronts[at(f)];
    gather(front);
    const auto solve = kColumns == 1 ? kernels_->solve_lower : kernels_->solve_lower_4;
    solve(factor_.get() + front.panel, front.pivot_tiles, front.row_tiles, x);
    scatter(front, front.num_pivots + front.num_rows);
  }
  for (auto f = wanted.rbegin(); f != wanted.rend(); ++f) {
    const Front& front = layout_.fronts[at(*f)];
    gather(front);
    if constexpr (kColumns == 1) {
      kernels_->solve_upper(factor_.get() + front.panel, front.pivot_tiles, front.row_tiles, x, space.sums.get());
    } else {
      kernels_->solve_upper_4(factor_.get() + front.panel, front.pivot_tiles, front.row_tiles, x);
    }
    scatter(front, front.num_pivots);
  }
}

MultifrontalCholesky::Branches MultifrontalCholesky::branches_to(const std::vector<int>& vertices) const {
  std::vector<char> visited(layout_.fronts.size(), 0);
  for (int v : vertices) {
    for (int f = layout_.front_of_vertex.at(at(v)); f != -1 && !visited[at(f)]; f = layout_.fronts[at(f)].parent) {
      visited[at(f)] = 1;
    }
  }
  Branches branches;
  for (std::size_t f = 0; f < visited.size(); ++f) {
    if (visited[f]) branches.push_back(static_cast<int>(f));
  }
  return branches;
}

std::size_t MultifrontalCholesky::memory() const {
  return sizeof(Tile) * (layout_.panel_tiles + layout_.schur_tiles) + sizeof(MatrixEntry) * layout_.entries.size();
}

}  // namespace wirewarp
