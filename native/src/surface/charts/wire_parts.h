// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/outline.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Of a wire inside a chart.
WireKind kind_of(double tolerance);

/// Cuts each wire into parts at every vertex on a seam or boundary, and where it passes to a chart that touches the
/// first one in a vertex alone, and hands them to their charts, with the lengths that their eases set. A run of a
/// wire along the outline is a part of kind boundary, one for each of its sides, and ends at the outline's junctions.
/// The parts of a closed wire do not depend on where its list begins. Returns for each wire whether it is all outline.
std::vector<char> assign_wire_parts(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut,
                                    const Outline& outline, const std::vector<HalfedgeHandle>& half_edge_of_side,
                                    std::vector<Chart>& charts);

/// Multiplies the lengths that single sides set.
void assign_eases(const std::vector<Ease>& eases, const EdgeTable& edges, const SurfaceCut& cut,
                  const std::vector<HalfedgeHandle>& half_edge_of_side, std::vector<Chart>& charts);

}  // namespace wirewarp
