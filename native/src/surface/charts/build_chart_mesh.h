// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Fills mesh, source_vertex and boundary_loops from chart.source_face, and writes the half-edge of each of its sides
/// into half_edge_of_side (#input sides). The chart must be an oriented manifold.
/// Vertices and faces keep the input's order.
void build_chart_mesh(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut, Chart& chart,
                      std::vector<HalfedgeHandle>& half_edge_of_side);

}  // namespace wirewarp
