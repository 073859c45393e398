// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/stop_token.h"
#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

struct CutPlaces {
  CutMask forbidden;                // edges that no cut may follow; empty: cuts may follow all edges
  std::vector<VertexHandle> image;  // mirror image of each vertex; empty: cuts need not be symmetric
};

/// Returns a cut that divides a chart into parts for which lies_flat() is true, as far as possible. Returns an empty
/// cut if the search is canceled, or if no edge can be cut.
CutMask open_chart(const Chart& chart, const std::function<bool(const Chart& part)>& lies_flat, const StopToken& stop,
                   CutPlaces places = {});

}  // namespace wirewarp
