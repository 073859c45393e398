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

/// Returns whether a piece is closed, has handles, has an outline that is too short to enclose it, is flipped or
/// overlaps itself. Also returns true if a piece without wires inside has infeasible lengths, or needs a strain of 1 or
/// more.
bool lacks_seams(const FlatPiece& piece);

/// Returns the darts of propose_darts() or the seams of propose_seams() for these pieces. If a search for cut sets is
/// canceled, returns the sets found by then. Throws the errors of these functions, and Stopped if nothing was found by
/// then.
std::vector<DartProposal> best_cuts(const FlatPieces& pieces, CutKind kind, const CutOptions& cut_options,
                                    const ExactEvaluation& exact, CutProgress& progress);

}  // namespace wirewarp
