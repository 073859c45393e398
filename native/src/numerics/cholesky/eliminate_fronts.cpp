// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/eliminate_fronts.h"

#include <algorithm>

namespace wirewarp {
namespace {

double& entry(Tile& tile, int row, int column) { return tile.entries[kTile * column + row]; }

/// Returns the number of rows (4, 2 or 1) to process together from row i on. These rows are in one tile of the child,
/// and map to consecutive rows of one tile of the parent.
int rows_alike(const int* target, int i, int num_rows) {
  for (const int run : {4, 2}) {
    if (i % run == 0 && i + run <= num_rows && target[i] % run == 0 && target[i + run - 1] == target[i] + run - 1) {
      return run;
    }
  }
  return 1;
}

/// Adds columns begin to end - 1 of kRows rows to columns target[begin] to target[end - 1]. `to` starts at
/// first_column. Columns of a tile are 4 numbers apart.
template <int kRows>
void add_rows(const double* from, const int* target, int begin, int end, double* to, int first_column) {
  for (int j = begin; j < end; ++j) {
    for (int i = 0; i < kRows; ++i) to[kTile * (target[j] - first_column) + i] += from[kTile * j + i];
  }
}

void add_rows(int num_rows, const double* from, const int* target, int begin, int end, double* to, int first_column) {
  const auto add = num_rows == 4 ? add_rows<4> : num_rows == 2 ? add_rows<2> : add_rows<1>;
  add(from, target, begin, end, to, first_column);
}

/// Extend-add: adds each entry of the child's Schur complement to its place in the parent's front.
void add_child(const FrontLayout& layout, int child, int node, Tile* factor, Tile* schurs) {
  const Front& from = layout.fronts[child];
  const Front& to = layout.fronts[node];
  const int m = to.pivot_tiles;
  const int num_rows = layout.unknowns_per_vertex * from.num_rows;
  const int* const rows = layout.rows_in_parent.data() + from.first_row;
  const int num_pivots = static_cast<int>(std::lower_bound(rows, rows + num_rows, kTile * m) - rows);
  for (int i = 0; i < num_rows;) {
    const int run = rows_alike(rows, i, num_rows);
    const int t = rows[i] / kTile;
    const double* const source = schurs[from.schur + triangle_size(i / kTile)].entries + i % kTile;
    double* const panel = factor[to.panel + panel_row(t, m)].entries + rows[i] % kTile;
    add_rows(run, source, rows, 0, std::min(i + run, num_pivots), panel, 0);
    if (t >= m) {
      double* const schur = schurs[to.schur + triangle_size(t - m)].entries + rows[i] % kTile;
      add_rows(run, source, rows, num_pivots, i + run, schur, kTile * m);
    }
    i += run;
  }
}

}  // namespace

void assemble_front(const FrontLayout& layout, int node, const double* values, Tile* factor, Tile* schurs) {
  const Front* const front = &layout.fronts[node];
  const int m = front->pivot_tiles, r = front->row_tiles;
  Tile* const panel = factor + front->panel;
  std::fill_n(panel, panel_row(m + r, m), Tile{});
  std::fill_n(schurs + front->schur, triangle_size(r), Tile{});
  for (int i = layout.unknowns_per_vertex * front->num_pivots; i < kTile * m; ++i) {
    entry(panel[panel_row(m - 1, m) + (m - 1)], i % kTile, i % kTile) = 1;
  }
  for (int e = front[0].first_entry; e < front[1].first_entry; ++e) {
    const MatrixEntry& from = layout.entries[e];
    panel[from.place / 16].entries[from.place % 16] += values[from.source];
  }
  for (int c = front[0].first_child; c < front[1].first_child; ++c) {
    add_child(layout, layout.children[c], node, factor, schurs);
  }
}

}  // namespace wirewarp
