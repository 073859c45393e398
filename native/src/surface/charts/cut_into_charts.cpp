// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/cut_into_charts.h"

#include "base/work_meter.h"
#include "surface/charts/build_chart_mesh.h"
#include "surface/charts/chart_faults.h"
#include "surface/charts/outline.h"
#include "surface/charts/surface_cut.h"
#include "surface/charts/wire_parts.h"

namespace wirewarp {

namespace {

std::vector<Chart> charts_of(const SurfaceCut& cut) {
  std::vector<Chart> charts(static_cast<std::size_t>(cut.num_charts));
  for (int f = 0; f < static_cast<int>(cut.chart_of_face.size()); ++f) {
    charts[cut.chart_of_face[f]].source_face.push_back(f);
  }
  return charts;
}

}  // namespace

Charts cut_into_charts(const FlattenInput& input, const EdgeTable& edges, const StopToken& stop,
                       const std::vector<int>& fans) {
  stop.check();
  const SurfaceCut cut = cut_along_seams(input.faces, edges, input.seams);
  std::vector<std::optional<FlattenError>> faults = find_chart_faults(input, edges, cut, fans);

  Charts result;
  result.charts = charts_of(cut);
  WorkMeter work(stop);
  ChartHandles handles{std::vector<VertexHandle>(static_cast<std::size_t>(cut.num_fans)),
                       std::vector<HalfedgeHandle>(3 * static_cast<std::size_t>(input.faces.rows()))};
  for (std::size_t c = 0; c < result.charts.size(); ++c) {
    Chart& chart = result.charts[c];
    work.did(chart.source_face.size());
    chart.error = std::move(faults[c]);
    if (chart.error) continue;
    build_chart_mesh(input, edges, cut, chart, handles);
    chart.error = find_topology_fault(chart);
  }
  stop.check();
  const Outline outline = trace_outline(input.faces, edges, cut);
  result.seams = assign_boundary_chains(edges, cut, outline, result.charts);
  stop.check();
  result.is_boundary_wire = assign_wire_parts(input, edges, cut, outline, handles.half_edge_of_side, result.charts);
  assign_eases(input.eases, edges, cut, handles.half_edge_of_side, result.charts);
  return result;
}

Charts list_charts(const FlattenInput& input, const EdgeTable& edges, const FlattenError& error) {
  Charts result;
  result.charts = charts_of(cut_along_seams(input.faces, edges, input.seams));
  for (Chart& chart : result.charts) chart.error = error;
  result.is_boundary_wire.assign(input.wires.size(), 0);
  return result;
}

}  // namespace wirewarp
