// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/piece_search.h"

namespace wirewarp {

/// Returns the darts of a piece that help, the best first. The darts are geodesics across triangles, from the outline
/// to a tip. Straightens `chains`, and moves the ends of the best lines as long as exact evaluations improve. Compares
/// darts by the strain of the piece, and drops darts with a puckering tip. The number of darts is not limited to
/// cut_options.count. DartProposal::piece is not set.
std::vector<DartProposal> smooth_darts(const PieceSearch& search, const std::vector<HalfEdgeChain>& chains,
                                       const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                                       const ExactEvaluation& exact);

}  // namespace wirewarp
