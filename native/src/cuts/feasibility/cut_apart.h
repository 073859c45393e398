// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Cuts a chart along edges. Returns the resulting charts with their parts of the wires. The sources of these charts
/// are the vertices, faces and wire parts of the given chart.
std::vector<Chart> cut_apart(const Chart& chart, const CutMask& cut);

/// Returns a connected chart with its vertices and faces in the given order. The sources of the result are the
/// vertices, faces and wire parts of the given chart.
Chart renumbered(const Chart& chart, const std::vector<VertexHandle>& vertices, const std::vector<FaceHandle>& faces);

}  // namespace wirewarp
