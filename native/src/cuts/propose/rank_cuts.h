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
  int places;      // number of places with cuts, none beside another
  double share;    // share of all tried cuts that are returned, so that the fine mesh decides between almost equal ones
  double longest;  // length of one cut, scene units
};

/// Returns the best candidates of a chart, with their ends moved to the best places, and candidates that are almost as
/// good, the best first. All returned cuts lower E. stop: polled in any thread. Throws Stopped.
std::vector<RankedCut> rank_cuts(const Chart& chart, const SmoothPathFinder& paths,
                                 const std::vector<CutEnds>& candidates, const InternalOptions& options,
                                 const CutLimits& limits, const StopToken& stop);

}  // namespace wirewarp
