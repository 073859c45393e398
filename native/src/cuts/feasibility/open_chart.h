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

/// Returns a cut that divides a chart without a good flat shape into parts with good flat shapes.
///
/// The candidates open tubes and handles, slit the chart, or cut it in two. Their flat shapes without fixed lengths
/// rank them: first by the area that is flipped or overlaps, then by length and distortion. Then lies_flat() judges the
/// parts of the best few. The first candidate that succeeds is the result. If none succeeds, the result is the
/// candidate that leaves the least area without a good flat shape. The search cuts this area again, a few times at
/// most.
///
/// Returns an empty cut if the search is canceled, or if no edge can be cut, for example because all edges are
/// forbidden.
CutMask open_chart(const Chart& chart, const std::function<bool(const Chart& part)>& lies_flat, const StopToken& stop,
                   CutPlaces places = {});

}  // namespace wirewarp
