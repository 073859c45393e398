// SPDX-License-Identifier: GPL-3.0-or-later
// Where to cut a chart that cannot lie flat.
#pragma once

#include <functional>
#include <vector>

#include "charts/chart.h"
#include "feasibility/cut_mask.h"

namespace wirewarp {

/// How a cut is tried.
struct SeamTrials {
  std::function<bool(const Chart&)> lies_flat;  // a whole run: lengths, no flips, no overlap
  std::function<bool()> go_on;                  // false: stop
};

/// Where cuts may run.
struct SeamPlaces {
  CutMask barred;                   // edges where none may; no entries: anywhere
  std::vector<VertexHandle> image;  // the mirror image of each vertex, which cuts have too; no entries: there is none
};

/// Edges of the input along which a chart that has no good flat shape should be cut: opened where it is a tube or has
/// handles, slit, or cut in two, and what results again where it still does not lie flat. Judged by flattening: first
/// all candidates without holding any length, then the best of them in full, a few for each chart. If none serves, the
/// best of them. Among those that serve, the shortest with the least distortion. Empty if trials stop it, or where no
/// edge is left to cut.
std::vector<VertexPair> propose_seams(const Chart& chart, const SeamTrials& trials, SeamPlaces places = {});

}  // namespace wirewarp
