// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "cuts/propose/cut_candidates.h"

namespace wirewarp {

struct RankedCut {
  CutEnds ends;
  double energy = 0;  // E of Eq. (4) when cut so, scene units squared
};

struct CutLimits {
  int places;      // where cuts are, none of them beside another
  double share;    // of all cuts that were tried: beside those others that are as good, for the finer mesh to choose
  double longest;  // of one, scene units
};

/// The best candidates of a chart with their ends moved to where they serve best, and others that are as good, the best
/// first; none that does not lower E. stop: polled in any thread. Throws Stopped.
std::vector<RankedCut> rank_cuts(const Chart& chart, const SmoothPathFinder& paths,
                                 const std::vector<CutEnds>& candidates, const InternalOptions& options,
                                 const CutLimits& limits, const StopToken& stop);

}  // namespace wirewarp
