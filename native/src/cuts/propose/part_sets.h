// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/cut_progress.h"
#include "cuts/propose/flat_pieces.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Returns whether a piece may be divided into parts: it is closed, and no wires, eases or thickness restrict its cuts.
bool can_be_divided(const FlatPiece& piece, const ExactEvaluation& exact);

struct PartSets {
  std::vector<DartProposal> sets;  // the longest first
  bool are_sewable = false;        // whether a set is within the accepted strain, and has few pieces, all wide enough
};

/// Returns cut sets along the necks of a piece and along planes through its parts. can_be_divided() must be true.
/// - Empty if the piece cannot be divided into few flat parts, or should be cut along its sharp edges
/// - If canceled: the sets found so far; throws Stopped if there are none
PartSets part_sets(const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                   const ExactEvaluation& exact, CutProgress& progress);

}  // namespace wirewarp
