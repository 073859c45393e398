// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart_errors.h"

#include <set>

#include "check_input/sentence.h"

namespace wirewarp {

FlattenError cancelled() { return FlattenError(ErrorCode::cancelled, "Cancelled before this piece was flat."); }

FlattenError infeasible_lengths(const Chart& chart, const WireNetwork& network, const std::vector<Wire>& wires,
                                const InnerSolution& solution) {
  std::set<int> in_chart;
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind != WireKind::boundary) in_chart.insert(part.wire_index);
  }
  const std::string names = in_chart.empty() ? "" : " and " + name_wires(wires, {in_chart.begin(), in_chart.end()});
  ErrorElements elements;
  for (const WireEdge& edge : network.edges) {
    elements.edges.push_back(source_edge(chart, chart.mesh.halfedge_handle(edge.edge, 0)));
  }
  elements.faces = chart.source_face;
  return FlattenError(ErrorCode::infeasible_lengths,
                      "The outline" + names + " of the piece around face " + std::to_string(chart.source_face.front()) +
                          " cannot keep " + (in_chart.empty() ? "its length" : "their lengths") +
                          " in the plane (a gap of " + percent(solution.closure_residual) + " of a loop stays open): " +
                          (in_chart.empty() ? "" : "clear a wire or ") + "mark another seam.",
                      elements);
}

FlattenError not_solvable(const Chart& chart) {
  return FlattenError(ErrorCode::not_solvable,
                      "The piece around face " + std::to_string(chart.source_face.front()) +
                          " cannot be laid out in double precision, for its faces differ too much in size: merge "
                          "vertices that lie very close together, or remesh it.",
                      {{}, {}, chart.source_face});
}

}  // namespace wirewarp
