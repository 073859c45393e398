// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/chart_errors.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/arguments.h"
#include "base/sentence.h"
#include "surface/charts/isoperimetric.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {

FlattenError cancelled() { return FlattenError(ErrorCode::cancelled, ErrorArguments{}); }

namespace {

void add_edges(const Chart& chart, const HalfEdgeChain& chain, std::vector<VertexPair>& edges) {
  for (const HalfedgeHandle h : chain) edges.push_back(source_edge(chart, h));
}

std::vector<VertexPair> edges_of(const Chart& chart, const std::vector<ProposedTolerance>& tolerances) {
  std::vector<VertexPair> edges;
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind == WireKind::boundary) continue;
    const bool is_named = std::any_of(tolerances.begin(), tolerances.end(), [&](const ProposedTolerance& proposed) {
      return proposed.wire == part.wire_index;
    });
    if (is_named) add_edges(chart, part.half_edges, edges);
  }
  return edges;
}

/// Returns the input faces with heights below a millionth of the greatest height, the smallest first.
std::vector<int> small_faces(const Chart& chart) {
  constexpr double kSmall = 1e-6;  // a micrometer beside faces of a meter, so such a face is a fault
  std::vector<std::pair<double, int>> by_height;
  for (const FaceHandle f : chart.mesh.faces()) {
    double longest = 0;
    for (const HalfedgeHandle h : chart.mesh.fh_range(f)) longest = std::max(longest, edge_length(chart.mesh, h));
    by_height.emplace_back(2 * face_area(chart.mesh, f) / longest, chart.source_face[f.idx()]);
  }
  std::sort(by_height.begin(), by_height.end());
  std::vector<int> small;
  for (const auto& [height, face] : by_height) {
    if (height < kSmall * by_height.back().first) small.push_back(face);
  }
  return small;
}

/// Returns the error of a chart for which no shape with all lengths was found. The error names all faces. If the limit
/// of factorizations ended the search, the error names this limit, too.
FlattenError infeasible(const Chart& chart, ErrorArguments arguments, ErrorElements elements, const Options& options,
                        bool ran_out) {
  if (ran_out) arguments["max_factorizations"] = options.max_factorizations;
  elements.faces = chart.source_face;
  return FlattenError(ErrorCode::infeasible_lengths, std::move(arguments), std::move(elements));
}

}  // namespace

FlattenError with_proposed_seams(FlattenError error, std::vector<VertexPair> proposed_seams) {
  if (error.code != ErrorCode::closed_chart && error.code != ErrorCode::handles) return error;
  error.elements.proposed_seams = std::move(proposed_seams);
  return FlattenError(error.code, std::move(error.arguments), std::move(error.elements));
}

FlattenError outline_too_short(const Chart& chart, std::vector<VertexPair> proposed_seams) {
  std::vector<double> lengths = longest_lengths(chart);
  std::vector<std::pair<double, int>> loops;  // length of each loop, and an input vertex on it
  for (std::size_t i = 0; i < lengths.size(); ++i)
    loops.emplace_back(lengths[i], source_ends(chart, chart.boundary_loops[i].front())[0]);
  std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  ErrorElements elements;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    lengths[i] = loops[i].first;
    elements.vertices.push_back(loops[i].second);
  }
  for (const HalfEdgeChain& loop : chart.boundary_loops) add_edges(chart, loop, elements.edges);
  elements.faces = chart.source_face;
  elements.proposed_seams = std::move(proposed_seams);
  const double share = isoperimetric_ratio(chart);
  return FlattenError(
      ErrorCode::boundary_too_short,
      ErrorArguments{{"lengths", std::move(lengths)}, {"share", share}, {"least_energy", least_shape_error(share)}},
      std::move(elements));
}

FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, const Options& options,
                              std::vector<ProposedTolerance> tolerances, bool ran_out) {
  ErrorElements elements;
  elements.edges = edges_of(chart, tolerances);
  std::vector<int> indices;
  for (const ProposedTolerance& proposed : tolerances) indices.push_back(proposed.wire);
  ErrorArguments arguments = arguments_of_wires(wires, std::move(indices));
  arguments["reason"] = std::string("wires");
  arguments["is_refined"] = options.method == Method::refined;
  elements.proposed_tolerances = std::move(tolerances);
  return infeasible(chart, std::move(arguments), std::move(elements), options, ran_out);
}

FlattenError infeasible_outline(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool ran_out) {
  ErrorElements elements;
  for (const HalfEdgeChain& loop : chart.boundary_loops) add_edges(chart, loop, elements.edges);
  elements.proposed_seams = std::move(proposed_seams);
  return infeasible(chart, {{"reason", "outline"}, {"has_wires", has_wires(chart)}}, std::move(elements), options,
                    ran_out);
}

FlattenError infeasible_stretch(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool is_good_unstretched, bool ran_out) {
  ErrorElements elements;
  elements.proposed_seams = std::move(proposed_seams);
  return infeasible(chart, {{"reason", "stretch"}, {"is_good_unstretched", is_good_unstretched}}, std::move(elements),
                    options, ran_out);
}

FlattenError needs_refinement(const Chart& chart) {
  return FlattenError(ErrorCode::infeasible_lengths, ErrorArguments{{"reason", "method"}}, {{}, {}, chart.source_face});
}

std::optional<FlattenError> elastic_outline(const Chart& chart, const std::vector<Wire>& wires) {
  std::set<int> elastic;
  std::set<VertexPair> edges;
  for (const WirePart& part : chart.wire_parts) {
    if (!is_elastic_boundary(part)) continue;
    elastic.insert(part.wire_index);
    for (const HalfedgeHandle h : part.half_edges) edges.insert(source_edge(chart, h));
  }
  if (elastic.empty()) return std::nullopt;
  const std::vector<int> indices(elastic.begin(), elastic.end());
  ErrorArguments arguments = arguments_of_wires(wires, indices);
  arguments["name"] = "method";
  arguments["value"] = "wirewarp++";
  arguments["allowed"] = "be refined, or " +
                         name_wires(indices, std::get<std::vector<std::string>>(arguments["wire_names"])) +
                         " must have an ease instead of a tolerance along seams and outlines";
  return FlattenError(ErrorCode::invalid_option, std::move(arguments),
                      {{}, {edges.begin(), edges.end()}, chart.source_face});
}

FlattenError not_solvable(const Chart& chart) {
  const std::vector<int> small = small_faces(chart);
  const char* reason = small.empty() ? "precision" : "sizes";
  return FlattenError(ErrorCode::not_solvable, ErrorArguments{{"reason", reason}, {"face", chart.source_face.front()}},
                      {{}, {}, small.empty() ? chart.source_face : small});
}

FlattenError not_joined(const Chart& chart) {
  ErrorElements elements;
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind != WireKind::boundary) add_edges(chart, part.half_edges, elements.edges);
  }
  for (std::size_t i = 1; i < chart.boundary_loops.size(); ++i) {
    add_edges(chart, chart.boundary_loops[i], elements.edges);
  }
  return FlattenError(ErrorCode::not_solvable,
                      ErrorArguments{{"reason", "helper_wires"}, {"face", chart.source_face.front()}},
                      std::move(elements));
}

}  // namespace wirewarp
