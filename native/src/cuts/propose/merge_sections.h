// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "cuts/feasibility/mirrored_cuts.h"
#include "cuts/propose/flat_pieces.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// A cut of a chart and all pieces of the input with it.
struct CutState {
  CutMask cut;
  FlatPieces pieces;
};

/// The move "merge": takes sections of seams out of a cut, the longest first, and halves of sections if no whole one
/// may go, until none is left that may. A section goes with its mirror image, after an exact evaluation of the pieces
/// beside it: they have to lie flat, with this strain at most. Every state on the way is a cut under which all lies
/// flat. One state for each of the strains, which rise: each goes on from the one before. report: called with the share
/// of the work that is done. Throws Stopped.
std::vector<CutState> merge_sections(CutState state, const Chart& chart, const MirroredCuts& mirrored,
                                     const std::vector<double>& most_strains, const ExactEvaluation& exact,
                                     const std::function<void(double)>& report);

}  // namespace wirewarp
