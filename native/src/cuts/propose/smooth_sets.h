// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/propose/flat_pieces.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Returns a cut set whose seams and darts are smooth lines across triangles, as smooth as the strain of its parts and
/// their width allow. Lines stay on their edges if nothing smoother is allowed. set: a set of this piece along edges.
/// most_strain: the smooth set leaves no more strain than that, and no more than twice the strain of the set. Throws
/// Stopped.
DartProposal smooth_set(const DartProposal& set, double most_strain, const FlatPieces& pieces, std::size_t piece,
                        const CutOptions& cut_options, const ExactEvaluation& exact);

}  // namespace wirewarp
