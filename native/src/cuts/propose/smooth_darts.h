// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/piece_search.h"

namespace wirewarp {

/// The darts of a piece as smooth lines across triangles: geodesics from the outline to a tip. Chains of edges are
/// straightened, and ends of the best lines moved as long as that helps, every time by an exact evaluation. The strain
/// of the piece counts, and a tip must not pucker. Any number, the best first, without piece. Empty if none helps.
std::vector<DartProposal> smooth_darts(const PieceSearch& search, const std::vector<HalfEdgeChain>& chains,
                                       const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                                       const ExactEvaluation& exact);

}  // namespace wirewarp
