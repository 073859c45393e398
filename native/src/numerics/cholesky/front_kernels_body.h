// SPDX-License-Identifier: GPL-3.0-or-later
// The code of the kernels. Each front_kernels_*.cpp defines three constants, then includes this file once. kLanes is
// the number of numbers in a register of the processor. kRowsAtOnce and kRowsSummed are the numbers of row tiles that
// fit in the registers during factorization and during the sums of back substitution.
//
// A file that is compiled for newer processors must not share inline functions with other files. The linker keeps one
// of the copies, and old processors might then execute new instructions. Therefore everything here is in an unnamed
// namespace and uses only C functions, nothing of the standard library or Eigen.
#include <math.h>

#include "numerics/cholesky/front_kernels.h"

namespace wirewarp {
namespace {

using Lanes = double __attribute__((vector_size(8 * kLanes), may_alias));

constexpr int kParts = kTile / kLanes;  // registers per column of a tile
constexpr int kBlock = 32;              // tiles of pivots in a block; a few of its rows fit in the first-level cache

inline const Lanes& column(const Tile& tile, int j, int part) {
  return *reinterpret_cast<const Lanes*>(tile.entries + kTile * j + kLanes * part);
}
inline Lanes& column(Tile& tile, int j, int part) {
  return *reinterpret_cast<Lanes*>(tile.entries + kTile * j + kLanes * part);
}

using TileInRegisters = Lanes[kTile][kParts];

inline void load(const Tile& tile, TileInRegisters& x) {
#pragma GCC unroll 4
  for (int j = 0; j < kTile; ++j) {
#pragma GCC unroll 4
    for (int part = 0; part < kParts; ++part) x[j][part] = column(tile, j, part);
  }
}

inline void store(const TileInRegisters& x, Tile& tile) {
#pragma GCC unroll 4
  for (int j = 0; j < kTile; ++j) {
#pragma GCC unroll 4
    for (int part = 0; part < kParts; ++part) column(tile, j, part) = x[j][part];
  }
}

/// Multiplies x by L⁻ᵀ from the right, for a diagonal tile of L.
inline void divide(TileInRegisters& x, const Tile& diagonal) {
#pragma GCC unroll 4
  for (int j = 0; j < kTile; ++j) {
#pragma GCC unroll 4
    for (int part = 0; part < kParts; ++part) {
#pragma GCC unroll 4
      for (int k = 0; k < j; ++k) x[j][part] -= x[k][part] * diagonal.entries[kTile * k + j];
      x[j][part] *= diagonal.entries[kTile * j + j];
    }
  }
}

/// Subtracts Σ a bᵀ, a sum over num_tiles tiles, from each tile c. Each c has its own tiles a, and all share the tiles
/// b. If a diagonal tile of L is given, then multiplies each c by L⁻ᵀ from the right.
template <int kRows>
inline void subtract_product(Tile* const (&c)[kRows], const Tile* const (&a)[kRows], const Tile* b, int num_tiles,
                             const Tile* diagonal) {
  TileInRegisters sum[kRows];
#pragma GCC unroll 4
  for (int row = 0; row < kRows; ++row) load(*c[row], sum[row]);
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
    for (int row = 0; row < kRows; ++row) divide(sum[row], *diagonal);
  }
#pragma GCC unroll 4
  for (int row = 0; row < kRows; ++row) store(sum[row], *c[row]);
}

/// Returns the factor by which rows of factor f are multiplied: Uᵀ for L, and L for Uᵀ. A symmetric matrix has only one
/// factor, L = Uᵀ.
template <typename T, int kFactors>
inline T& other(T (&factors)[kFactors], int f) {
  return factors[kFactors - 1 - f];
}

template <int kFactors>
inline bool factor_tile(Tile* const (&tiles)[kFactors]) {
  for (int j = 0; j < kTile; ++j) {
    const double pivot = tiles[0]->entries[kTile * j + j];
    if (!(pivot > 0 && pivot < HUGE_VAL)) return false;
    const double inverse = 1 / sqrt(pivot);
    for (Tile* const tile : tiles) {
      double* const l = tile->entries;
      l[kTile * j + j] = inverse;
      for (int i = j + 1; i < kTile; ++i) l[kTile * j + i] *= inverse;
    }
    for (int f = 0; f < kFactors; ++f) {
      double* const l = tiles[f]->entries;
      const double* const u = other(tiles, f)->entries;
      for (int k = j + 1; k < kTile; ++k) {
        for (int i = k; i < kTile; ++i) l[kTile * k + i] -= l[kTile * j + i] * u[kTile * j + k];
      }
    }
  }
  return true;
}

/// The tiles of a front, both panel and Schur complement, by row tile t and column tile j.
struct FrontTiles {
  Tile* panel;
  Tile* schur;
  int m;

  Tile* at(int t, int j) const { return j < m ? panel + panel_row(t, m) + j : schur + triangle_size(t - m) + (j - m); }
};

/// Updates a factor's tiles in kRows rows from t on and columns [begin, end) by the pivots [first, last). Columns
/// before `last` are final afterwards.
template <int kRows>
void update_rows(const FrontTiles& front, const FrontTiles& other, int t, int first, int last, int begin, int end) {
  Tile* c[kRows];
  const Tile* a[kRows];
  for (int row = 0; row < kRows; ++row) a[row] = front.at(t + row, first);
  for (int j = begin; j < end; ++j) {
    for (int row = 0; row < kRows; ++row) c[row] = front.at(t + row, j);
    const bool is_factor = j < last;
    subtract_product(c, a, other.at(j, first), (is_factor ? j : last) - first, is_factor ? other.at(j, j) : nullptr);
  }
}

/// Updates kRows rows from t on below a block of pivots, in all columns up to the diagonal. The block's columns come
/// first, then the columns that are not factored yet, then S.
template <int kRows, int kFactors>
void update_below(const FrontTiles (&fronts)[kFactors], int t, int first, int last) {
  for (int f = 0; f < kFactors; ++f) update_rows<kRows>(fronts[f], other(fronts, f), t, first, last, first, last);
  for (int f = 0; f < kFactors; ++f) {
    update_rows<kRows>(fronts[f], other(fronts, f), t, first, last, last, t + 1);
    for (int row = 1; row < kRows; ++row) {
      update_rows<1>(fronts[f], other(fronts, f), t + row, first, last, t + 1, t + row + 1);
    }
  }
}

template <int kFactors>
bool factor_fronts(const FrontTiles (&fronts)[kFactors], int m, int r) {
  for (int first = 0; first < m; first += kBlock) {
    const int last = first + kBlock < m ? first + kBlock : m;
    for (int t = first; t < last; ++t) {
      for (int f = 0; f < kFactors; ++f) update_rows<1>(fronts[f], other(fronts, f), t, first, last, first, t);
      Tile* diagonal[kFactors];
      for (int f = 0; f < kFactors; ++f) {
        diagonal[f] = fronts[f].at(t, t);
        Tile* const tile[1] = {diagonal[f]};
        const Tile* const row[1] = {fronts[f].at(t, first)};
        subtract_product(tile, row, other(fronts, f).at(t, first), t - first, nullptr);
      }
      if (!factor_tile(diagonal)) return false;
    }
    int t = last;
    for (; t + kRowsAtOnce <= m + r; t += kRowsAtOnce) update_below<kRowsAtOnce>(fronts, t, first, last);
    for (; t < m + r; ++t) update_below<1>(fronts, t, first, last);
  }
  return true;
}

bool factor(Tile* panel, Tile* schur, int m, int r) {
  const FrontTiles fronts[] = {{panel, schur, m}};
  return factor_fronts(fronts, m, r);
}

bool factor_lu(Tile* lower, Tile* lower_schur, Tile* upper, Tile* upper_schur, int m, int r) {
  const FrontTiles fronts[] = {{lower, lower_schur, m}, {upper, upper_schur, m}};
  return factor_fronts(fronts, m, r);
}

}  // namespace
}  // namespace wirewarp

#include "numerics/cholesky/front_substitution_body.h"

namespace wirewarp {
namespace {

constexpr FrontKernels kKernels = {factor, factor_lu, solve_lower, solve_lower_4, solve_upper, solve_upper_4};

}  // namespace
}  // namespace wirewarp
