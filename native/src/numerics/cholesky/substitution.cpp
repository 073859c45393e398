// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/substitution.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

namespace wirewarp {
namespace {

// Number of tiles in 2 MB of a factor. More tiles are worth a second thread, because reading 2 MB takes 0.2 ms, several
// times as long as starting a thread.
constexpr std::size_t kTilesWorthThreads = 1 << 14;

using Columns = Eigen::Ref<Eigen::MatrixXd>;

/// A front's rows of up to kColumns right-hand sides, stored row by row.
template <int kColumns>
class FrontRows {
 public:
  explicit FrontRows(const FrontLayout& layout)
      : layout_(layout), x_(new Tile[layout.largest_front]), sums_(new Tile[layout.largest_front]) {}

  double* numbers() const { return x_[0].entries; }
  Tile* sums() const { return sums_.get(); }  // work space of the kernels

  /// Copies the rows of a front: its pivots and own rows from `own`, which has one row per unknown, and its other rows
  /// from `shared`, which has only the unknowns of shared vertices.
  void gather(const Front& front, const Columns& own, const Columns& shared) const {
    std::fill_n(numbers(), kColumns * kTile * (front.pivot_tiles + front.row_tiles), 0.0);
    const int num_own = front.num_pivots + front.num_own_rows;
    const auto read = [](double& x, const double& y) { x = y; };
    for_each(front, 0, num_own, own, read);
    for_each(front, num_own, front.num_pivots + front.num_rows, shared, read);
  }
  void scatter(const Front& front, Columns& own, Columns& shared) const {
    const int num_own = front.num_pivots + front.num_own_rows;
    const auto write = [](double& x, double& y) { y = x; };
    for_each(front, 0, num_own, own, write);
    for_each(front, num_own, front.num_pivots + front.num_rows, shared, write);
  }
  void scatter_pivots(const Front& front, Columns& own) const {
    for_each(front, 0, front.num_pivots, own, [](double& x, double& y) { y = x; });
  }

 private:
  /// Calls function(number in x_, number in columns) for the vertices begin to end - 1 of a front.
  template <typename AllColumns, typename Function>
  void for_each(const Front& front, int begin, int end, AllColumns& columns, const Function& function) const {
    const int k = layout_.unknowns_per_vertex;
    const int num_columns = kColumns == 1 ? 1 : static_cast<int>(columns.cols());
    const int* const vertices = layout_.vertices.data() + front.first_vertex;
    for (int place = begin; place < end; ++place) {
      double* const x = numbers() + kColumns * layout_.row_of(front, place);
      auto* const y = columns.data() + k * vertices[place];
      for (int i = 0; i < k; ++i) {
        for (int c = 0; c < num_columns; ++c) function(x[kColumns * i + c], y[i + c * columns.outerStride()]);
      }
    }
  }

  const FrontLayout& layout_;
  std::unique_ptr<Tile[]> x_, sums_;
};

}  // namespace

Substitution::Substitution(const FrontLayout& layout, bool in_threads, const FrontKernels& kernels)
    : layout_(layout),
      in_threads_(in_threads),
      kernels_(kernels),
      all_(fronts_where(std::vector<char>(layout.fronts.size(), 1))) {}

void Substitution::forward(const Tile* factor, Columns b, const FrontSet& nonzero) const {
  if (b.rows() != layout_.num_unknowns) throw std::invalid_argument("substitution: b must have one row per unknown");
  for (Eigen::Index first = 0; first < b.cols(); first += kTile) {
    const Eigen::Index columns = std::min<Eigen::Index>(kTile, b.cols() - first);
    const auto substitute = columns == 1 ? &Substitution::forward_4<1> : &Substitution::forward_4<kTile>;
    (this->*substitute)(factor, b.middleCols(first, columns), nonzero);
  }
}

void Substitution::back(const Tile* factor, Columns b, const FrontSet& wanted) const {
  for (Eigen::Index first = 0; first < b.cols(); first += kTile) {
    const Eigen::Index columns = std::min<Eigen::Index>(kTile, b.cols() - first);
    const auto substitute = columns == 1 ? &Substitution::back_4<1> : &Substitution::back_4<kTile>;
    (this->*substitute)(factor, b.middleCols(first, columns), wanted);
  }
}

template <int kColumns>
void Substitution::forward_4(const Tile* factor, Columns b, const FrontSet& nonzero) const {
  const auto solve = kColumns == 1 ? kernels_.solve_lower : kernels_.solve_lower_4;
  const auto visit = [&](const std::vector<int>& fronts, Columns shared) {
    const FrontRows<kColumns> rows(layout_);
    Columns own = b;
    for (int f : fronts) {
      const Front& front = layout_.fronts[f];
      rows.gather(front, own, shared);
      solve(factor + front.panel, front.pivot_tiles, front.row_tiles, rows.numbers());
      rows.scatter(front, own, shared);
    }
  };
  const auto num_shared = static_cast<Eigen::Index>(layout_.shared_vertices.size());
  const int k = layout_.unknowns_per_vertex;
  std::array<Eigen::MatrixXd, FrontSet::num_shares> sums;
  nonzero.visit_subtrees(in_threads_, [&](std::size_t share, const std::vector<int>& fronts) {
    sums[share].setZero(k * num_shared, b.cols());
    visit(fronts, sums[share]);
  });
  for (const Eigen::MatrixXd& sum : sums) {
    for (Eigen::Index i = 0; i < num_shared; ++i) {
      b.middleRows(k * layout_.shared_vertices[static_cast<std::size_t>(i)], k) += sum.middleRows(k * i, k);
    }
  }
  visit(nonzero.ancestors, b);
}

template <int kColumns>
void Substitution::back_4(const Tile* factor, Columns b, const FrontSet& wanted) const {
  const auto visit = [&](const std::vector<int>& fronts, const Columns& shared) {
    const FrontRows<kColumns> rows(layout_);
    Columns own = b;
    for (auto f = fronts.rbegin(); f != fronts.rend(); ++f) {
      const Front& front = layout_.fronts[*f];
      rows.gather(front, own, shared);
      const Tile* const panel = factor + front.panel;
      if constexpr (kColumns == 1) {
        kernels_.solve_upper(panel, front.pivot_tiles, front.row_tiles, rows.numbers(), rows.sums());
      } else {
        kernels_.solve_upper_4(panel, front.pivot_tiles, front.row_tiles, rows.numbers());
      }
      rows.scatter_pivots(front, own);
    }
  };
  visit(wanted.ancestors, b);
  const auto num_shared = static_cast<Eigen::Index>(layout_.shared_vertices.size());
  const int k = layout_.unknowns_per_vertex;
  Eigen::MatrixXd shared(k * num_shared, b.cols());
  for (Eigen::Index i = 0; i < num_shared; ++i) {
    shared.middleRows(k * i, k) = b.middleRows(k * layout_.shared_vertices[static_cast<std::size_t>(i)], k);
  }
  wanted.visit_subtrees(in_threads_, [&](std::size_t, const std::vector<int>& fronts) { visit(fronts, shared); });
}

FrontSet Substitution::fronts_reaching(const std::vector<int>& vertices) const {
  std::vector<char> is_visited(layout_.fronts.size(), 0);
  for (int v : vertices) {
    for (int f = layout_.front_of_vertex.at(v); f != -1 && !is_visited[f]; f = layout_.fronts[f].parent) {
      is_visited[f] = 1;
    }
  }
  return fronts_where(is_visited);
}

FrontSet Substitution::others(const FrontSet& fronts) const {
  std::vector<char> is_other(layout_.fronts.size(), 1);
  for (const std::vector<int>* part : {&fronts.subtrees[0], &fronts.subtrees[1], &fronts.ancestors}) {
    for (int f : *part) is_other[f] = 0;
  }
  return fronts_where(is_other);
}

FrontSet Substitution::fronts_where(const std::vector<char>& is_visited) const {
  FrontSet visited;
  std::size_t tiles = 0;
  const auto add = [&](const std::vector<int>& fronts, std::vector<int>& kept) {
    for (int f : fronts) {
      if (!is_visited[f]) continue;
      const Front& front = layout_.fronts[f];
      kept.push_back(f);
      tiles += panel_row(front.pivot_tiles + front.row_tiles, front.pivot_tiles);
    }
  };
  for (std::size_t share = 0; share < FrontSet::num_shares; ++share) {
    add(layout_.all_fronts.subtrees[share], visited.subtrees[share]);
  }
  visited.are_worth_threads = tiles > kTilesWorthThreads;
  add(layout_.all_fronts.ancestors, visited.ancestors);
  return visited;
}

}  // namespace wirewarp
