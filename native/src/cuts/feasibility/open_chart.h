// SPDX-License-Identifier: GPL-3.0-or-later
// Finds cuts for a chart that has no good flat shape.
#pragma once

#include <functional>
#include <vector>

#include "base/stop_token.h"
#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Edges that cuts must avoid, and the symmetry that cuts must have.
struct CutPlaces {
  CutMask forbidden;                // edges that no cut may follow; empty: none
  std::vector<VertexHandle> image;  // mirror image of each vertex, to make cuts symmetric; empty: none
};

/// Returns a cut that divides a chart without a good flat shape into parts with good flat shapes. Tubes and handles are
/// opened, and charts are slit or cut in two. Parts without a flat shape are cut again. All candidates are flattened
/// without fixed lengths, then lies_flat() judges the best few for each chart. Of the successful cuts, the cut with the
/// least cost of length and distortion is returned. If all cuts fail, the best of them is returned. The result is empty
/// if the search is canceled, or if no edge can be cut, for example because all edges are forbidden.
CutMask open_chart(const Chart& chart, const std::function<bool(const Chart& part)>& lies_flat, const StopToken& stop,
                   CutPlaces places = {});

}  // namespace wirewarp
