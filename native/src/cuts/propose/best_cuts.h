// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/cut_candidates.h"
#include "cuts/propose/cut_progress.h"
#include "cuts/propose/flat_pieces.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Throws invalid_option.
void check_cut_options(const CutOptions& cut_options, const FlattenInput& input, std::size_t num_pieces);

/// The piece lacks seams: it is closed, has handles, or its outline cannot hold it. Neither the mesh nor its wires are
/// at fault.
bool lacks_seams(const FlatPiece& piece);

/// What propose_darts() and propose_seams() propose for these pieces. Throws their errors, and Stopped.
std::vector<DartProposal> best_cuts(const FlatPieces& pieces, CutKind kind, const CutOptions& cut_options,
                                    const ExactEvaluation& exact, CutProgress& progress);

}  // namespace wirewarp
