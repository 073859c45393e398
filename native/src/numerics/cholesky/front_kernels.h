// SPDX-License-Identifier: GPL-3.0-or-later
// Dense arithmetic on a frontal matrix, in tiles of 4 by 4. With m tiles of pivots and r tiles of rows below them:
//
//   row tile t   0 ... m-1 (pivots)   tiles (t, 0) to (t, t)        of L₁₁   ⎫ panel, row by row
//   row tile t   m ... m+r-1 (below)  tiles (t, 0) to (t, m-1)      of L₂₁   ⎭
//   row tile t   0 ... r-1            tiles (t, 0) to (t, t)        of the Schur complement, row by row
//
// So every sum over pivots reads memory in order, for both factors of a product L Lᵀ, without copying data. Incomplete
// tiles are padded: pivots by the identity, rows below by zeros.
#pragma once

#include <cstddef>

namespace wirewarp {

/// A block of 4 by 4 numbers, stored column by column. In a diagonal block of L, the diagonal is stored inverted and
/// the entries above it are undefined.
struct alignas(64) Tile {
  double entries[16];
};

constexpr int kTile = 4;  // numbers in an AVX2 register; larger tiles would pad small fronts more

// These two functions have internal linkage: front_kernels_body.h explains why inline functions must not be shared.

/// Returns the number of tiles of a triangle with num_tiles rows of tiles.
static constexpr std::size_t triangle_size(int num_tiles) {
  return static_cast<std::size_t>(num_tiles) * static_cast<std::size_t>(num_tiles + 1) / 2;
}

/// Returns the index of the first tile of row tile t in a panel with m tiles of pivots.
static constexpr std::size_t panel_row(int t, int m) {
  return t < m ? triangle_size(t) : triangle_size(m) + static_cast<std::size_t>(t - m) * static_cast<std::size_t>(m);
}

/// The kernels for one kind of processor. They allocate nothing and access only their arguments.
struct FrontKernels {
  /// Replaces [A₁₁; A₂₁] by [L₁₁; L₂₁] with L₁₁ L₁₁ᵀ = A₁₁, L₂₁ = A₂₁ L₁₁⁻ᵀ, and S by S − L₂₁ L₂₁ᵀ. Returns false
  /// immediately at a pivot that is not a positive finite number.
  bool (*factor)(Tile* panel, Tile* schur, int m, int r);

  /// Factors a front of an unsymmetric matrix A = L U. L and Uᵀ each have a panel and a triangle of S. The diagonals of
  /// L and Uᵀ are equal: the square roots of the pivots.
  bool (*factor_lu)(Tile* lower, Tile* lower_schur, Tile* upper, Tile* upper_schur, int m, int r);

  /// Replaces [x₁; x₂] by [L₁₁⁻¹ x₁; x₂ − L₂₁ L₁₁⁻¹ x₁], for one right-hand side, or for four that are stored row by
  /// row. x: 4 (m + r) rows, with the alignment of a tile.
  void (*solve_lower)(const Tile* panel, int m, int r, double* x);
  void (*solve_lower_4)(const Tile* panel, int m, int r, double* x);

  /// Replaces x₁ by L₁₁⁻ᵀ (x₁ − L₂₁ᵀ x₂), for one or four right-hand sides. sums: work space of m tiles.
  void (*solve_upper)(const Tile* panel, int m, int r, double* x, Tile* sums);
  void (*solve_upper_4)(const Tile* panel, int m, int r, double* x);
};

extern const FrontKernels kPlainKernels;
extern const FrontKernels kAvx2Kernels;  // call only if has_avx2()

/// Returns whether this processor has AVX2 and FMA.
bool has_avx2();

const FrontKernels& fastest_kernels();

}  // namespace wirewarp
