// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where to cut a chart that has no good flat shape.
#pragma once

#include <functional>
#include <vector>

#include "base/stop_token.h"
#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Where cuts may run.
struct CutPlaces {
  CutMask forbidden;                // edges that no cut may follow; empty: none
  std::vector<VertexHandle> image;  // mirror image of each vertex, to make cuts symmetric; empty: none
};

/// Returns a cut of a chart without a good flat shape, such that the parts have good flat shapes. Tubes and handles are
/// opened, and charts are slit or cut in two; parts without a flat shape are cut again. All candidates are flattened
/// without any fixed length; then lies_flat judges the best few for each chart. The shortest successful cut with the
/// least distortion is returned, or the best one if none succeeds. The result is empty if the search is stopped, or if
/// no edge is left to cut.
CutMask open_chart(const Chart& chart, const std::function<bool(const Chart& part)>& lies_flat, const StopToken& stop,
                   CutPlaces places = {});

}  // namespace wirewarp
