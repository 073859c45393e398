// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of the mesh that concern one chart alone.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Returns for each chart its first fault as an oriented manifold with faces of positive area. Charts may touch in a
/// vertex.
std::vector<std::optional<FlattenError>> find_chart_faults(const FlattenInput& input, const EdgeTable& edges,
                                                           const SurfaceCut& cut);

/// Returns the handles of a chart whose mesh and boundary loops are built: 1 for a torus.
long count_handles(const Chart& chart);

/// Returns a fault of a chart whose mesh and boundary loops are built: closed_chart or handles.
std::optional<FlattenError> find_topology_fault(const Chart& chart);

}  // namespace wirewarp
