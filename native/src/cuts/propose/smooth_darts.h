// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/piece_search.h"

namespace wirewarp {

/// Returns the darts of a piece as smooth lines across triangles. The lines are geodesics from the outline to a tip.
/// Straightens chains of edges, and moves the ends of the best lines as long as exact evaluations improve. Compares
/// darts by the strain of the piece, and drops darts with a puckering tip. Returns any number of darts, the best first;
/// empty if no dart helps. DartProposal::piece is not set.
std::vector<DartProposal> smooth_darts(const PieceSearch& search, const std::vector<HalfEdgeChain>& chains,
                                       const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                                       const ExactEvaluation& exact);

}  // namespace wirewarp
