// SPDX-License-Identifier: GPL-3.0-or-later
#include "charts/cut_into_charts.h"

#include "charts/build_chart_mesh.h"
#include "charts/chart_faults.h"
#include "charts/outline.h"
#include "charts/surface_cut.h"
#include "charts/wire_parts.h"

namespace wirewarp {

Charts cut_into_charts(const FlattenInput& input, const EdgeTable& edges) {
  const SurfaceCut cut = cut_along_seams(input.faces, edges, input.seams);
  std::vector<std::optional<FlattenError>> faults = find_chart_faults(input, edges, cut);

  Charts result;
  result.charts.resize(cut.num_charts);
  for (int f = 0; f < input.faces.rows(); ++f) {
    result.charts[cut.chart_of_face[f]].source_face.push_back(f);
  }
  std::vector<HalfedgeHandle> half_edge_of_side(3 * static_cast<std::size_t>(input.faces.rows()));
  for (std::size_t c = 0; c < result.charts.size(); ++c) {
    Chart& chart = result.charts[c];
    chart.error = std::move(faults[c]);
    if (chart.error) continue;
    build_chart_mesh(input, edges, cut, chart, half_edge_of_side);
    chart.error = find_topology_fault(chart);
  }
  const Outline outline = trace_outline(input.faces, edges, cut);
  result.seams = assign_boundary_chains(edges, cut, outline, result.charts);
  result.is_boundary_wire = assign_wire_parts(input, edges, cut, outline, half_edge_of_side, result.charts);
  return result;
}

}  // namespace wirewarp
