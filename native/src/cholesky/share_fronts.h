// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cholesky/front_layout.h"

namespace wirewarp {

/// Fills fronts_of_thread and last_fronts: subtrees of about equal work for each thread, split further at the top as
/// long as that makes the whole faster.
void share_fronts(FrontLayout& layout, int num_threads);

/// Fills Front::schur and schur_tiles. Each thread has stacks of its own, and those that come last too: a Schur
/// complement lies on one stack while its children's are taken off the other.
void place_schur_complements(FrontLayout& layout);

}  // namespace wirewarp
