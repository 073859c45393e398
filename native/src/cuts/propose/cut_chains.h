// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the sections of a cut: first those from one vertex where cuts end or meet to the next such vertex, then
/// closed rings.
std::vector<HalfEdgeChain> sections_of(const HalfEdgeMesh& mesh, const CutMask& cut);

/// Returns the ends of the cut edges in the input, section by section.
std::vector<VertexPair> edges_by_section(const Chart& chart, const CutMask& cut);

}  // namespace wirewarp
