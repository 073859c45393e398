// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "cuts/propose/cut_candidates.h"

namespace wirewarp {

struct RankedCut {
  CutEnds ends;
  double energy = 0;  // E of Eq. (4) with the cut, scene units squared
};

struct CutLimits {
  int places;      // largest number of best cuts, no two beside each other
  double share;    // further cuts are returned, up to this share of all tried cuts
  double longest;  // largest length of a cut, scene units
};

/// Returns cuts that lower E, the best first. Their ends may differ from the ends of the candidates. Includes almost
/// equal cuts, between which only the fine mesh can decide. Polls `stop` in any thread, and throws Stopped.
std::vector<RankedCut> rank_cuts(const Chart& chart, const SmoothPathFinder& paths,
                                 const std::vector<CutEnds>& candidates, const InternalOptions& options,
                                 const CutLimits& limits, const StopToken& stop);

}  // namespace wirewarp
