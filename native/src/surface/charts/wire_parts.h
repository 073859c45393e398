// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/outline.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Returns the kind of a wire with this tolerance, if the wire is inside a chart.
WireKind kind_of(double tolerance);

/// Adds the parts of all wires to the charts, and multiplies target lengths by the eases of the wires. The parts do not
/// depend on where the list of a closed wire starts. Returns per wire whether it is wholly on the outline.
std::vector<char> assign_wire_parts(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut,
                                    const Outline& outline, const std::vector<HalfedgeHandle>& half_edge_of_side,
                                    std::vector<Chart>& charts);

/// Multiplies the target lengths of sides that have their own ease by 1 + Ease::ratio.
void assign_eases(const std::vector<Ease>& eases, const EdgeTable& edges, const SurfaceCut& cut,
                  const std::vector<HalfedgeHandle>& half_edge_of_side, std::vector<Chart>& charts);

}  // namespace wirewarp
