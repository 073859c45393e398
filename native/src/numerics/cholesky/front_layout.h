// SPDX-License-Identifier: GPL-3.0-or-later
// What a multifrontal factorization knows before it meets a number: the rows of each front, where everything lies in
// memory, and what can be done at the same time.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "numerics/cholesky/front_set.h"
#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

/// One supernode. Its vertices are its pivots, then its rows; each has unknowns_per_vertex unknowns in a row.
struct Front {
  int parent;             // -1 at a root
  int first_vertex;       // in FrontLayout::vertices
  int num_pivots;         // vertices
  int num_rows;           // vertices
  int num_own_rows;       // vertices; the first rows, pivots in the same share of subtrees
  int pivot_tiles;        // m
  int row_tiles;          // r
  int first_entry;        // in FrontLayout::entries; the next front's are the end
  int first_child;        // in FrontLayout::children
  int first_row;          // in FrontLayout::rows_in_parent
  std::size_t panel = 0;  // first tile, among all panels
  std::size_t schur = 0;  // first tile, in the space for Schur complements

  /// Multiplications of tiles that its elimination takes, about.
  double work() const {
    const double m = pivot_tiles, r = row_tiles;
    return m * m * m / 6 + m * m * r / 2 + m * r * r / 2 + (m + r) * (m + r);
  }
};

/// Where a stored entry of the matrix goes: panel entry `place` += values[source].
struct MatrixEntry {
  int source;
  std::uint32_t place;
};

struct FrontLayout {
  int unknowns_per_vertex;
  Eigen::Index num_unknowns;
  std::vector<Front> fronts;        // in postorder, and one past the last
  std::vector<int> vertices;        // pivots and rows of all fronts, in the order of elimination in each; rows that are
                                    // not a front's own by their place among shared_vertices
  std::vector<int> rows_in_parent;  // for each unknown of each front's rows: its row in the parent's front
  std::vector<int> children;        // fronts
  std::vector<MatrixEntry> entries;
  std::vector<int> front_of_vertex;  // where it is a pivot
  std::size_t panel_tiles = 0;
  std::size_t schur_tiles = 0;
  int largest_front = 0;  // tiles, pivots and rows
  int kept_root = -1;     // front that is assembled and not eliminated, -1: none

  FrontSet all_fronts;               // to eliminate
  std::vector<int> shared_vertices;  // pivots of the ancestors of all_fronts and of the kept root

  /// Row of the first unknown of a front's vertex, of the padded rows of the front.
  int row_of(const Front& front, int place) const {
    return place < front.num_pivots ? unknowns_per_vertex * place
                                    : 4 * front.pivot_tiles + unknowns_per_vertex * (place - front.num_pivots);
  }
};

/// lower: the lower triangle, compressed. keeps_root: the last node of the tree is not to be eliminated. Throws
/// std::invalid_argument if the tree does not fit it.
FrontLayout lay_out_fronts(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree,
                           int unknowns_per_vertex, bool keeps_root = false);

}  // namespace wirewarp
