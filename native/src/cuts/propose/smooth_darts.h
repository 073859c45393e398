// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/piece_search.h"

namespace wirewarp {

/// Returns the helpful darts of a piece as geodesics, the best first; DartProposal::piece is not set. Starts from
/// `chains`, and moves their ends. The number of darts is not limited to cut_options.count.
std::vector<DartProposal> smooth_darts(const PieceSearch& search, const std::vector<HalfEdgeChain>& chains,
                                       const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                                       const ExactEvaluation& exact);

}  // namespace wirewarp
