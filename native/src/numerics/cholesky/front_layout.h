// SPDX-License-Identifier: GPL-3.0-or-later
// The symbolic part of a multifrontal factorization: the rows of each front, the memory layout, and which fronts can be
// eliminated in parallel.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "numerics/cholesky/front_set.h"
#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

/// One supernode. Its vertices are its pivots, then its rows. Each vertex has unknowns_per_vertex consecutive unknowns.
struct Front {
  int parent;             // -1 at a root
  int first_vertex;       // index into FrontLayout::vertices
  int num_pivots;         // number of vertices that are pivots
  int num_rows;           // number of vertices in rows below the pivots
  int num_own_rows;       // number of leading rows whose vertices are pivots of fronts in the same share of subtrees
  int pivot_tiles;        // m: number of row tiles of pivots
  int row_tiles;          // r: number of row tiles below the pivots
  int first_entry;        // index into FrontLayout::entries; the next front's value is the end
  int first_child;        // index into FrontLayout::children
  int first_row;          // index into FrontLayout::rows_in_parent
  std::size_t panel = 0;  // index of the first tile among all panels
  std::size_t schur = 0;  // index of the first tile in the space for Schur complements

  /// Returns the approximate number of tile multiplications that the front's elimination takes.
  double work() const {
    const double m = pivot_tiles, r = row_tiles;
    return m * m * m / 6 + m * m * r / 2 + m * r * r / 2 + (m + r) * (m + r);
  }
};

/// A stored entry of the matrix: panel entry `place` += values[source].
struct MatrixEntry {
  int source;
  std::uint32_t place;
};

struct FrontLayout {
  int unknowns_per_vertex;
  Eigen::Index num_unknowns;
  std::vector<Front> fronts;        // in postorder, then an entry that marks the end
  std::vector<int> vertices;        // per front: its pivots, then its rows, both in elimination order; rows after the
                                    // first num_own_rows are indices into shared_vertices
  std::vector<int> rows_in_parent;  // for each unknown in the rows of each front: its row in the parent's front
  std::vector<int> children;        // children of each front
  std::vector<MatrixEntry> entries;
  std::vector<int> front_of_vertex;  // front in which each vertex is a pivot
  std::size_t panel_tiles = 0;
  std::size_t schur_tiles = 0;
  int largest_front = 0;  // largest number of row tiles of a front
  int kept_root = -1;     // front that is assembled but not eliminated; -1: none

  FrontSet all_fronts;               // fronts to eliminate
  std::vector<int> shared_vertices;  // pivots of all_fronts.ancestors and of the kept root

  /// Returns the row of the first unknown of the vertex at position `place` in a front. Padding counts as rows.
  int row_of(const Front& front, int place) const {
    return place < front.num_pivots ? unknowns_per_vertex * place
                                    : 4 * front.pivot_tiles + unknowns_per_vertex * (place - front.num_pivots);
  }
};

/// Returns the layout for a compressed lower triangle. keeps_root: whether the last node of the tree is not eliminated.
/// Throws std::invalid_argument if the tree does not match the matrix.
FrontLayout lay_out_fronts(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree,
                           int unknowns_per_vertex, bool keeps_root = false);

}  // namespace wirewarp
