// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check_input/sentence.h"
#include "feasibility/propose_seams.h"

namespace wirewarp {

FlattenError cancelled() { return FlattenError(ErrorCode::cancelled, "Cancelled before this piece was flat."); }

namespace {

/// "with a tolerance of 0.3 % to 1.2 % on wires 3 and 4 and with wire 7 (waist) free".
std::string name_tolerances(const std::vector<Wire>& wires, const std::vector<ProposedTolerance>& tolerances) {
  std::vector<int> elastic, free;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const ProposedTolerance& proposed : tolerances) {
    if (std::isinf(proposed.tolerance)) {
      free.push_back(proposed.wire);
      continue;
    }
    elastic.push_back(proposed.wire);
    least = std::min(least, proposed.tolerance);
    most = std::max(most, proposed.tolerance);
  }
  std::string text;
  if (!elastic.empty()) {
    text = "with a tolerance of " + (least < most ? percent(least) + " to " : "") + percent(most) + " on " +
           name_wires(wires, elastic);
  }
  if (free.empty()) return text;
  return text + (text.empty() ? "" : " and ") + "with " + name_wires(wires, free) + " free";
}

std::vector<VertexPair> edges_of(const Chart& chart, const std::vector<ProposedTolerance>& tolerances) {
  std::vector<VertexPair> edges;
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind == WireKind::boundary) continue;
    const bool is_named = std::any_of(tolerances.begin(), tolerances.end(), [&](const ProposedTolerance& proposed) {
      return proposed.wire == part.wire_index;
    });
    if (!is_named) continue;
    for (const HalfedgeHandle h : part.half_edges) edges.push_back(source_edge(chart, h));
  }
  return edges;
}

}  // namespace

FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, const Options& options,
                              std::vector<ProposedTolerance> tolerances, bool ran_out) {
  const std::string piece = "the piece around face " + std::to_string(chart.source_face.front());
  const std::string allow_more =
      "No flat shape of " + piece +
      " with all lengths was found within max_factorizations = " + std::to_string(options.max_factorizations) +
      ": raise it, or ";
  ErrorElements elements;
  elements.faces = chart.source_face;
  if (tolerances.empty()) {
    for (const HalfEdgeChain& loop : chart.boundary_loops) {
      for (const HalfedgeHandle h : loop) elements.edges.push_back(source_edge(chart, h));
    }
    elements.proposed_seams = propose_seams(chart);
    const bool has_wires = std::any_of(chart.wire_parts.begin(), chart.wire_parts.end(),
                                       [](const WirePart& part) { return part.kind != WireKind::boundary; });
    const std::string none_found = "No flat shape of " + piece + " was found that keeps the length of its outline" +
                                   (has_wires ? ", even with its wires free: " : ": ");
    const std::string message = (ran_out ? allow_more : none_found) + "mark a seam such as " +
                                name_elements("edge", elements.proposed_seams) + ".";
    return FlattenError(ErrorCode::infeasible_lengths, message, std::move(elements));
  }
  elements.edges = edges_of(chart, tolerances);
  const std::string looser =
      name_tolerances(wires, tolerances) + (options.method == Method::refined ? "." : ", by the refined method.");
  const std::string contradict = "Not all wires of " + piece + " can keep their lengths in the plane: it lies flat ";
  const std::string message = (ran_out ? allow_more + "lay it flat " : contradict) + looser;
  elements.proposed_tolerances = std::move(tolerances);
  return FlattenError(ErrorCode::infeasible_lengths, message, std::move(elements));
}

FlattenError needs_refinement(const Chart& chart) {
  return FlattenError(ErrorCode::infeasible_lengths,
                      "Bent first, the wires of the piece around face " + std::to_string(chart.source_face.front()) +
                          " find no flat shape: take the refined method, which keeps them within their tolerances.",
                      {{}, {}, chart.source_face});
}

FlattenError not_solvable(const Chart& chart) {
  return FlattenError(ErrorCode::not_solvable,
                      "The piece around face " + std::to_string(chart.source_face.front()) +
                          " cannot be laid out in double precision, for its faces differ too much in size: merge "
                          "vertices that lie very close together, or remesh it.",
                      {{}, {}, chart.source_face});
}

}  // namespace wirewarp
