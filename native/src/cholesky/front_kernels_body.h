// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels themselves. Each front_kernels_*.cpp includes them once, after it has said how many numbers a register of
// its processor holds (kLanes) and how many row tiles its registers can accumulate at once (kRowsAtOnce).
//
// Files compiled for a newer processor must share nothing inline with others: of two copies of an inline function the
// linker keeps one, and would hand the new instructions to old processors. So all here is in an unnamed namespace, and
// nothing of the standard library or of Eigen is used but C functions.
#include <math.h>

#include "cholesky/front_kernels.h"

namespace wirewarp {
namespace {

using Lanes = double __attribute__((vector_size(8 * kLanes), may_alias));

constexpr int kParts = kTile / kLanes;  // registers for a column of a tile
constexpr int kBlock = 32;              // tiles of pivots whose product with a few rows stays in the first-level cache

inline const Lanes& column(const Tile& tile, int j, int part) {
  return *reinterpret_cast<const Lanes*>(tile.entries + kTile * j + kLanes * part);
}
inline Lanes& column(Tile& tile, int j, int part) {
  return *reinterpret_cast<Lanes*>(tile.entries + kTile * j + kLanes * part);
}

/// c −= Σ a bᵀ over a run of tiles, for kRows row tiles c and a and one row tile b. Then, with a diagonal tile of L,
/// c := c L⁻ᵀ.
template <int kRows>
inline void subtract_product(Tile* const (&c)[kRows], const Tile* const (&a)[kRows], const Tile* b, int num_tiles,
                             const Tile* diagonal) {
  Lanes sum[kRows][kTile][kParts];
#pragma GCC unroll 4
  for (int row = 0; row < kRows; ++row) {
#pragma GCC unroll 4
    for (int j = 0; j < kTile; ++j) {
#pragma GCC unroll 4
      for (int part = 0; part < kParts; ++part) sum[row][j][part] = column(*c[row], j, part);
    }
  }
  for (int t = 0; t < num_tiles; ++t) {
#pragma GCC unroll 4
    for (int k = 0; k < kTile; ++k) {
#pragma GCC unroll 4
      for (int j = 0; j < kTile; ++j) {
        const double factor = b[t].entries[kTile * k + j];
#pragma GCC unroll 4
        for (int row = 0; row < kRows; ++row) {
#pragma GCC unroll 4
          for (int part = 0; part < kParts; ++part) sum[row][j][part] -= column(a[row][t], k, part) * factor;
        }
      }
    }
  }
  if (diagonal != nullptr) {
#pragma GCC unroll 4
    for (int row = 0; row < kRows; ++row) {
#pragma GCC unroll 4
      for (int part = 0; part < kParts; ++part) {
#pragma GCC unroll 4
        for (int j = 0; j < kTile; ++j) {
#pragma GCC unroll 4
          for (int k = 0; k < j; ++k) sum[row][j][part] -= sum[row][k][part] * diagonal->entries[kTile * k + j];
          sum[row][j][part] *= diagonal->entries[kTile * j + j];
        }
      }
    }
  }
#pragma GCC unroll 4
  for (int row = 0; row < kRows; ++row) {
#pragma GCC unroll 4
    for (int j = 0; j < kTile; ++j) {
#pragma GCC unroll 4
      for (int part = 0; part < kParts; ++part) column(*c[row], j, part) = sum[row][j][part];
    }
  }
}

/// Cholesky factorization of a tile; false at a pivot that is not a positive finite number.
inline bool factor_tile(Tile& tile) {
  double* const l = tile.entries;
  for (int j = 0; j < kTile; ++j) {
    const double pivot = l[kTile * j + j];
    if (!(pivot > 0 && pivot < HUGE_VAL)) return false;
    const double inverse = 1 / sqrt(pivot);
    l[kTile * j + j] = inverse;
    for (int i = j + 1; i < kTile; ++i) l[kTile * j + i] *= inverse;
    for (int k = j + 1; k < kTile; ++k) {
      for (int i = k; i < kTile; ++i) l[kTile * k + i] -= l[kTile * j + i] * l[kTile * j + k];
    }
  }
  return true;
}

/// The tiles of a front in one numbering: row tile t, column tile j.
struct FrontTiles {
  Tile* panel;
  Tile* schur;
  int m;

  Tile* at(int t, int j) const { return j < m ? panel + panel_row(t, m) + j : schur + triangle_size(t - m) + (j - m); }
};

/// Tiles (t, j) of kRows rows from t on, for columns j from begin to end, less the product of pivots first to j or
/// last, whichever comes first; columns before last are divided by their diagonal tile, which makes them columns of L.
template <int kRows>
void update_rows(const FrontTiles& front, int t, int first, int last, int begin, int end) {
  Tile* c[kRows];
  const Tile* a[kRows];
  for (int row = 0; row < kRows; ++row) a[row] = front.at(t + row, first);
  for (int j = begin; j < end; ++j) {
    for (int row = 0; row < kRows; ++row) c[row] = front.at(t + row, j);
    const bool is_factor = j < last;
    subtract_product(c, a, front.at(j, first), (is_factor ? j : last) - first, is_factor ? front.at(j, j) : nullptr);
  }
}

bool factor(Tile* panel, Tile* schur, int m, int r) {
  const FrontTiles front{panel, schur, m};
  for (int first = 0; first < m; first += kBlock) {
    const int last = first + kBlock < m ? first + kBlock : m;
    for (int t = first; t < last; ++t) {
      update_rows<1>(front, t, first, last, first, t);
      Tile* diagonal[1] = {front.at(t, t)};
      const Tile* row[1] = {front.at(t, first)};
      subtract_product<1>(diagonal, row, row[0], t - first, nullptr);
      if (!factor_tile(*diagonal[0])) return false;
    }
    // All columns up to the diagonal: the block's own, then those that are still to be factored, then S.
    for (int t = last; t < m + r; t += kRowsAtOnce) {
      if (t + kRowsAtOnce <= m + r) {
        update_rows<kRowsAtOnce>(front, t, first, last, first, t + 1);
        for (int below = t + 1; below < t + kRowsAtOnce; ++below) {
          update_rows<1>(front, below, first, last, t + 1, below + 1);
        }
      } else {
        for (int below = t; below < m + r; ++below) update_rows<1>(front, below, first, last, first, below + 1);
      }
    }
  }
  return true;
}

}  // namespace
}  // namespace wirewarp

#include "cholesky/front_substitution_body.h"

namespace wirewarp {
namespace {

constexpr FrontKernels kKernels = {factor, solve_lower, solve_lower_4, solve_upper, solve_upper_4};

}  // namespace
}  // namespace wirewarp
