// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "numerics/cholesky/front_layout.h"

namespace wirewarp {

/// Fills all_fronts with subtrees of about equal work. Splits heavy subtrees at their roots if this shortens the
/// elimination.
void partition_subtrees(FrontLayout& layout);

/// Fills Front::schur and schur_tiles. Each share of subtrees has two stacks, and so do the ancestors. A Schur
/// complement is pushed on one stack, while the Schur complements of the children are popped from the other stack.
void place_schur_complements(FrontLayout& layout);

/// Fills shared_vertices and Front::num_own_rows, and replaces the other rows with their indices in shared_vertices.
void list_shared_vertices(FrontLayout& layout);

}  // namespace wirewarp
