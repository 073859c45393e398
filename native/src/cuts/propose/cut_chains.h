// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the sections of a cut: first the sections between vertices at which cuts end or meet, then closed rings.
std::vector<HalfEdgeChain> sections_of(const HalfEdgeMesh& mesh, const CutMask& cut);

/// Returns the input vertices at the ends of each cut edge, section by section.
std::vector<VertexPair> edges_by_section(const Chart& chart, const CutMask& cut);

}  // namespace wirewarp
