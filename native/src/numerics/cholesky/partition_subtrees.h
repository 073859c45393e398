// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "numerics/cholesky/front_layout.h"

namespace wirewarp {

/// Fills all_fronts with two shares of subtrees, which have about equal work. Splits heavy subtrees at their roots if
/// this shortens the elimination.
void partition_subtrees(FrontLayout& layout);

/// Places the Schur complements in memory: fills Front::schur and schur_tiles.
void place_schur_complements(FrontLayout& layout);

/// Fills shared_vertices and Front::num_own_rows. Replaces the rows after the own rows with indices into
/// shared_vertices.
void list_shared_vertices(FrontLayout& layout);

}  // namespace wirewarp
