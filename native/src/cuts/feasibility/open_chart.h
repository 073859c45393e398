// SPDX-License-Identifier: GPL-3.0-or-later
// Where to cut a chart that cannot lie flat.
#pragma once

#include <functional>
#include <vector>

#include "base/stop_token.h"
#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Where cuts may run.
struct CutPlaces {
  CutMask forbidden;                // edges that no cut follows; no entries: none
  std::vector<VertexHandle> image;  // the mirror image of each vertex, which cuts have too; no entries: there is none
};

/// A cut under which a chart lies flat that has no good flat shape without: it is opened if it is a tube or has
/// handles, slit, or cut in two, and parts that still do not lie flat are cut again. All candidates are flattened
/// without any length held, then the best of them are judged by lies_flat, a few for each chart. If none works, the
/// best of them. Of those that work, the shortest with the least distortion. Empty if it is stopped, or if no edge is
/// left to cut.
CutMask open_chart(const Chart& chart, const std::function<bool(const Chart& part)>& lies_flat, const StopToken& stop,
                   CutPlaces places = {});

}  // namespace wirewarp
