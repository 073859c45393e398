// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/piece_search.h"

namespace wirewarp {

/// The darts of a piece as smooth lines across triangles: geodesics from the outline to a tip. The best darts along
/// edges are straightened, and ends of the best lines moved as long as that helps, every time by an exact evaluation.
/// What counts is the strain of the piece, or of the surroundings of the tip if that is more. The best first, without
/// piece. Throws no_proposal.
std::vector<DartProposal> smooth_darts(const PieceSearch& search, const FlatPieces& pieces, std::size_t piece,
                                       const CutOptions& cut_options, const ExactEvaluation& exact);

}  // namespace wirewarp
