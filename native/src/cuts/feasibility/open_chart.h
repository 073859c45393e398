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
  std::vector<VertexHandle> image;  // mirror image of each vertex; empty: cuts need not be symmetric
};

/// Returns a cut that divides a chart without a good flat shape into parts with good flat shapes. Opens tubes and
/// handles, and slits charts or cuts them in two. Flattens all candidates without fixed lengths, then lies_flat()
/// judges the best few. If candidates succeed, uses the candidate with the least cost of length and distortion.
/// Otherwise, uses the candidate that leaves the least area without a good flat shape, and cuts this area again a few
/// times. Returns an empty cut if the search is canceled, or if no edge can be cut, for example because all edges are
/// forbidden.
CutMask open_chart(const Chart& chart, const std::function<bool(const Chart& part)>& lies_flat, const StopToken& stop,
                   CutPlaces places = {});

}  // namespace wirewarp
