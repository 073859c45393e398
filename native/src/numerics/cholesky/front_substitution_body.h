// SPDX-License-Identifier: GPL-3.0-or-later
// Substitution in a front, for front_kernels_body.h. With one right-hand side, each number of L is used once, and
// memory bandwidth limits the speed. Four right-hand sides share each read.
#pragma once

namespace wirewarp {
namespace {

/// Computes Σ_j L_tj x_j over the columns j of a row tile of L, for one right-hand side.
inline void product(const Tile* l, int columns, const double* x, double (&result)[kTile]) {
  Lanes sum[kTile][kParts] = {};  // one sum per column of a tile, so that additions are independent
  for (int j = 0; j < columns; ++j) {
#pragma GCC unroll 4
    for (int k = 0; k < kTile; ++k) {
#pragma GCC unroll 4
      for (int part = 0; part < kParts; ++part) sum[k][part] += column(l[j], k, part) * x[kTile * j + k];
    }
  }
#pragma GCC unroll 4
  for (int part = 0; part < kParts; ++part) {
    const Lanes total = (sum[0][part] + sum[1][part]) + (sum[2][part] + sum[3][part]);
    for (int i = 0; i < kLanes; ++i) result[kLanes * part + i] = total[i];
  }
}

/// Prefetches tiles that back substitution needs soon. Back substitution reads memory backwards, and processors do not
/// prefetch in this direction. Without this function, back substitution takes 1.7 times as long.
inline void fetch_ahead(const Tile* tile) {
  constexpr int kTilesAhead = 128;  // 16 KB; with 64 tiles, a solve takes 5% longer; 256 tiles gain nothing
  constexpr int kLine = 64;         // bytes of a cache line
  // GCC's locality 2 is the second cache level. With 3, the first level, a solve takes a third longer.
  constexpr int kIntoSecondLevel = 2;
  const char* const ahead = reinterpret_cast<const char*>(tile - kTilesAhead);
  for (int byte = 0; byte < static_cast<int>(sizeof(Tile)); byte += kLine)
    __builtin_prefetch(ahead + byte, 0, kIntoSecondLevel);
}

/// Adds L_tj ∘ x_t to sums_j, for kRows row tiles t from `first` on and columns [begin, end).
///
/// ∘: multiplies each column of L_tj by x_t, entry by entry. The sum of column i is then entry i of L_tjᵀ x_t.
template <int kRows>
inline void add_products(const Tile* panel, int m, int first, int begin, int end, const double* x, Tile* sums) {
  const Tile* l[kRows];
  Lanes x_t[kRows][kParts];
#pragma GCC unroll 4
  for (int row = 0; row < kRows; ++row) {
    l[row] = panel + panel_row(first + row, m);
#pragma GCC unroll 4
    for (int part = 0; part < kParts; ++part) {
      x_t[row][part] = *reinterpret_cast<const Lanes*>(x + kTile * (first + row) + kLanes * part);
    }
  }
  for (int j = begin; j < end; ++j) {
#pragma GCC unroll 4
    for (int row = 0; row < kRows; ++row) fetch_ahead(l[row] + j);
#pragma GCC unroll 4
    for (int k = 0; k < kTile; ++k) {
#pragma GCC unroll 4
      for (int part = 0; part < kParts; ++part) {
        Lanes sum = column(sums[j], k, part);
#pragma GCC unroll 4
        for (int row = 0; row < kRows; ++row) sum += column(l[row][j], k, part) * x_t[row][part];
        column(sums[j], k, part) = sum;
      }
    }
  }
}

/// Adds the products of row tiles `first` to last - 1 in all columns before `end`. Starts with the last rows.
inline void add_all_products(const Tile* panel, int m, int first, int last, int end, const double* x, Tile* sums) {
  int t = last;
  for (; t - kRowsSummed >= first; t -= kRowsSummed)
    add_products<kRowsSummed>(panel, m, t - kRowsSummed, 0, end, x, sums);
  while (t > first) add_products<1>(panel, m, --t, 0, end, x, sums);
}

void solve_lower(const Tile* panel, int m, int r, double* x) {
  for (int t = 0; t < m + r; ++t) {
    const Tile* const l = panel + panel_row(t, m);
    double* const x_t = x + kTile * t;
    double known[kTile];
    product(l, t < m ? t : m, x, known);
    for (int i = 0; i < kTile; ++i) {
      x_t[i] -= known[i];
      if (t >= m) continue;
      for (int k = 0; k < i; ++k) x_t[i] -= l[t].entries[kTile * k + i] * x_t[k];
      x_t[i] *= l[t].entries[kTile * i + i];
    }
  }
}

void solve_upper(const Tile* panel, int m, int r, double* x, Tile* sums) {
  for (int j = 0; j < m; ++j) sums[j] = Tile{};
  add_all_products(panel, m, m, m + r, m, x, sums);
  for (int last = m; last > 0;) {
    const int first = last > kRowsSummed ? last - kRowsSummed : 0;
    for (int t = last - 1; t >= first; --t) {
      const Tile* const l = panel + panel_row(t, m);
      double* const x_t = x + kTile * t;
      for (int i = kTile - 1; i >= 0; --i) {
        for (int k = 0; k < kTile; ++k) x_t[i] -= sums[t].entries[kTile * i + k];
        for (int k = i + 1; k < kTile; ++k) x_t[i] -= l[t].entries[kTile * i + k] * x_t[k];
        x_t[i] *= l[t].entries[kTile * i + i];
      }
      add_products<1>(panel, m, t, first, t, x, sums);
    }
    add_all_products(panel, m, first, last, first, x, sums);
    last = first;
  }
}

/// Solves for four right-hand sides. Here, x_t is a tile: its columns are four rows of the right-hand sides.
void solve_lower_4(const Tile* panel, int m, int r, double* rows) {
  Tile* const x = reinterpret_cast<Tile*>(rows);
  for (int t = 0; t < m + r; ++t) {
    const Tile* const l = panel + panel_row(t, m);
    const int columns = t < m ? t : m;
    TileInRegisters sum;
    load(x[t], sum);
    for (int j = 0; j < columns; ++j) {
#pragma GCC unroll 4
      for (int k = 0; k < kTile; ++k) {
#pragma GCC unroll 4
        for (int i = 0; i < kTile; ++i) {
#pragma GCC unroll 4
          for (int part = 0; part < kParts; ++part) sum[i][part] -= column(x[j], k, part) * l[j].entries[kTile * k + i];
        }
      }
    }
    if (t < m) divide(sum, l[t]);
    store(sum, x[t]);
  }
}

/// Subtracts L_tjᵀ x_t from x_j for the columns j of row tile t of L.
inline void subtract_transposed(const Tile* l, int columns, const Tile& x_t, Tile* x) {
  TileInRegisters solved;
  load(x_t, solved);
  for (int j = 0; j < columns; ++j) {
#pragma GCC unroll 4
    for (int k = 0; k < kTile; ++k) {
#pragma GCC unroll 4
      for (int part = 0; part < kParts; ++part) {
        Lanes sum = column(x[j], k, part);
#pragma GCC unroll 4
        for (int i = 0; i < kTile; ++i) sum -= solved[i][part] * l[j].entries[kTile * k + i];
        column(x[j], k, part) = sum;
      }
    }
  }
}

inline void solve_tile_transposed(const Tile& l, Tile& x) {
  for (int i = kTile - 1; i >= 0; --i) {
    for (int part = 0; part < kParts; ++part) {
      for (int k = i + 1; k < kTile; ++k) column(x, i, part) -= column(x, k, part) * l.entries[kTile * i + k];
      column(x, i, part) *= l.entries[kTile * i + i];
    }
  }
}

void solve_upper_4(const Tile* panel, int m, int r, double* rows) {
  Tile* const x = reinterpret_cast<Tile*>(rows);
  for (int t = m; t < m + r; ++t) subtract_transposed(panel + panel_row(t, m), m, x[t], x);
  for (int t = m - 1; t >= 0; --t) {
    const Tile* const l = panel + panel_row(t, m);
    solve_tile_transposed(l[t], x[t]);
    subtract_transposed(l, t, x[t], x);
  }
}

}  // namespace
}  // namespace wirewarp
