// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/outline.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Returns the kind of a wire with this tolerance, if the wire is inside a chart.
WireKind kind_of(double tolerance);

/// Splits each wire into parts at every vertex on a seam or boundary, and where it passes to a chart that touches the
/// previous chart only at a vertex. Adds the parts, and the target lengths of their eases, to their charts. A run of a
/// wire along the outline becomes a part of kind boundary for each of its sides, and ends at the outline's junctions.
/// The parts of a closed wire do not depend on where its list starts. Returns for each wire whether all of it is on the
/// outline.
std::vector<char> assign_wire_parts(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut,
                                    const Outline& outline, const std::vector<HalfedgeHandle>& half_edge_of_side,
                                    std::vector<Chart>& charts);

/// Multiplies the target lengths of sides that have their own ease by 1 + Ease::ratio.
void assign_eases(const std::vector<Ease>& eases, const EdgeTable& edges, const SurfaceCut& cut,
                  const std::vector<HalfedgeHandle>& half_edge_of_side, std::vector<Chart>& charts);

}  // namespace wirewarp
