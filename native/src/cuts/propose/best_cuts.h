// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/cut_candidates.h"
#include "cuts/propose/cut_progress.h"
#include "cuts/propose/flat_pieces.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Throws invalid_option if an option is out of range.
void check_cut_options(const CutOptions& cut_options, const FlattenInput& input, std::size_t num_pieces);

/// Returns whether the piece lacks seams: it is closed, has handles, its outline cannot enclose it, it is flipped or
/// overlaps itself, or, without wires inside, its lengths are infeasible or its flat shape needs a strain of 1 or more.
bool lacks_seams(const FlatPiece& piece);

/// Returns what propose_darts() and propose_seams() propose for these pieces. If a search for cut sets is stopped,
/// returns the sets found by then. Throws their errors, and Stopped if nothing was found.
std::vector<DartProposal> best_cuts(const FlatPieces& pieces, CutKind kind, const CutOptions& cut_options,
                                    const ExactEvaluation& exact, CutProgress& progress);

}  // namespace wirewarp
