// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Handles in the meshes of all charts, one per fan (see SurfaceCut) and one per side of the input. A handle is invalid
/// until the mesh of its chart is built.
struct ChartHandles {
  std::vector<VertexHandle> vertex_of_fan;
  std::vector<HalfedgeHandle> half_edge_of_side;
};

/// Fills mesh, source_vertex and boundary_loops from chart.source_face, and sets the handles of the chart's fans and
/// sides. The chart must be an oriented manifold. Vertices and faces keep the input's order.
void build_chart_mesh(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut, Chart& chart,
                      ChartHandles& handles);

}  // namespace wirewarp
