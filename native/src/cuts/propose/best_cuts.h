// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/cut_candidates.h"
#include "cuts/propose/cut_progress.h"
#include "cuts/propose/flat_pieces.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Throws invalid_option if an option is out of range, or contains an edge that the mesh does not have.
void check_cut_options(const CutOptions& cut_options, const FlattenInput& input, std::size_t num_pieces);

/// Returns whether a piece needs seams to become flat, or to get a strain below kMostStrain. If the piece has wires
/// inside, infeasible lengths and high strain do not count, because wires may cause them.
bool lacks_seams(const FlatPiece& piece);

/// Returns the darts of propose_darts() or the seams of propose_seams(), or throws their errors. A canceled search for
/// cut sets returns the sets found so far, or throws Stopped if there are none.
std::vector<DartProposal> best_cuts(const FlatPieces& pieces, CutKind kind, const CutOptions& cut_options,
                                    const ExactEvaluation& exact, CutProgress& progress);

}  // namespace wirewarp
