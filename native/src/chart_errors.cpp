// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "errors/sentence.h"
#include "feasibility/isoperimetric.h"
#include "mesh/geometry.h"

namespace wirewarp {

FlattenError cancelled() { return FlattenError(ErrorCode::cancelled, "Cancelled before this piece was flat."); }

namespace {

/// "with a tolerance of 0.3% to 1.2% on wires 3 and 4 and with wire 7 (waist) free".
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

int source_of_loop(const Chart& chart, const HalfEdgeChain& loop) {
  return chart.source_vertex[chart.mesh.from_vertex_handle(loop.front()).idx()];
}

/// The longest few, as long as eases and tolerances let them be: "its outline, 0.4 units long at vertex 3," or "its
/// outlines, 0.4 units long at vertex 3 and 0.2 units long at vertex 7,".
std::string name_loops(const Chart& chart, const std::vector<HalfEdgeChain>& loops) {
  constexpr std::size_t kMostNamed = 5;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(loops.size(), kMostNamed); ++i) {
    names.push_back(rounded(longest_length(chart, loops[i])) + " units long at vertex " +
                    std::to_string(source_of_loop(chart, loops[i])));
  }
  return std::string(loops.size() == 1 ? "its outline, " : "its outlines, ") + listed(names, loops.size()) + ",";
}

std::string what_to_do(std::size_t num_loops) {
  if (num_loops == 1) return "cannot lie flat: mark another seam";
  if (num_loops == 2) return "is a tube: mark a seam from one opening to the other";
  return "cannot lie flat: mark seams between its " + std::to_string(num_loops) + " openings";
}

/// Input faces by height, the least first: those that are less than a millionth as high as the highest.
std::vector<int> small_faces(const Chart& chart) {
  constexpr double kSmall = 1e-6;
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

std::string allow_more(const Chart& chart, const Options& options) {
  return "No flat shape of " + name_piece(chart.source_face) +
         " with all lengths was found within max_factorizations = " + std::to_string(options.max_factorizations) +
         ": raise it, or ";
}

}  // namespace

FlattenError with_proposed_seams(FlattenError error, std::vector<VertexPair> proposed_seams) {
  if (error.code != ErrorCode::closed_chart && error.code != ErrorCode::handles) return error;
  std::string sentence = error.what();
  sentence.pop_back();
  sentence += such_as_along(proposed_seams) + ".";
  error.elements.proposed_seams = std::move(proposed_seams);
  return FlattenError(error.code, sentence, std::move(error.elements));
}

FlattenError outline_too_short(const Chart& chart, std::vector<VertexPair> proposed_seams) {
  std::vector<HalfEdgeChain> loops = chart.boundary_loops;
  std::stable_sort(loops.begin(), loops.end(), [&](const HalfEdgeChain& a, const HalfEdgeChain& b) {
    return longest_length(chart, a) > longest_length(chart, b);
  });
  ErrorElements elements;
  for (const HalfEdgeChain& loop : loops) elements.vertices.push_back(source_of_loop(chart, loop));
  for (const HalfEdgeChain& loop : chart.boundary_loops) add_edges(chart, loop, elements.edges);
  elements.faces = chart.source_face;
  const double share = isoperimetric_ratio(chart);
  const std::string message =
      introduce_piece(chart.source_face) + " " + what_to_do(loops.size()) + such_as_along(proposed_seams) + "; " +
      name_loops(chart, loops) + " can hold no more than " + percent(share) +
      " of its area in the plane (a distortion of at least " + rounded(least_shape_error(share)) + ").";
  elements.proposed_seams = std::move(proposed_seams);
  return FlattenError(ErrorCode::boundary_too_short, message, std::move(elements));
}

FlattenError infeasible_wires(const Chart& chart, const std::vector<Wire>& wires, const Options& options,
                              std::vector<ProposedTolerance> tolerances, bool ran_out) {
  ErrorElements elements;
  elements.faces = chart.source_face;
  elements.edges = edges_of(chart, tolerances);
  const std::string looser =
      name_tolerances(wires, tolerances) + (options.method == Method::refined ? "." : ", by the refined method.");
  const std::string contradict =
      "Not all wires of " + name_piece(chart.source_face) + " can keep their lengths in the plane: it lies flat ";
  const std::string message = (ran_out ? allow_more(chart, options) + "lay it flat " : contradict) + looser;
  elements.proposed_tolerances = std::move(tolerances);
  return FlattenError(ErrorCode::infeasible_lengths, message, std::move(elements));
}

FlattenError infeasible_outline(const Chart& chart, const Options& options, std::vector<VertexPair> proposed_seams,
                                bool ran_out) {
  ErrorElements elements;
  elements.faces = chart.source_face;
  for (const HalfEdgeChain& loop : chart.boundary_loops) add_edges(chart, loop, elements.edges);
  const std::string none_found = "No flat shape of " + name_piece(chart.source_face) +
                                 " was found that keeps the length of its outline" +
                                 (has_wires(chart) ? ", even with its wires free: " : ": ");
  const std::string message =
      (ran_out ? allow_more(chart, options) : none_found) + "mark a seam" + such_as_along(proposed_seams) + ".";
  elements.proposed_seams = std::move(proposed_seams);
  return FlattenError(ErrorCode::infeasible_lengths, message, std::move(elements));
}

FlattenError needs_refinement(const Chart& chart) {
  return FlattenError(ErrorCode::infeasible_lengths,
                      "Bent first, the wires of " + name_piece(chart.source_face) +
                          " find no flat shape: take the refined method, which keeps them within their tolerances.",
                      {{}, {}, chart.source_face});
}

namespace {

/// Those along the outline that have a tolerance, and their edges there.
struct GivingWires {
  std::set<int> wires;
  std::set<VertexPair> edges;
};

GivingWires find_giving_wires(const Chart& chart) {
  GivingWires giving;
  for (const WirePart& part : chart.wire_parts) {
    if (!gives_on_boundary(part)) continue;
    giving.wires.insert(part.wire_index);
    for (const HalfedgeHandle h : part.half_edges) giving.edges.insert(source_edge(chart, h));
  }
  return giving;
}

}  // namespace

void check_outline_is_settled(const Chart& chart, const std::vector<Wire>& wires) {
  const GivingWires giving = find_giving_wires(chart);
  if (giving.wires.empty()) return;
  throw FlattenError(ErrorCode::invalid_option,
                     "WireWarping++ keeps seams and outlines at one length, but along them runs " +
                         name_wires(wires, {giving.wires.begin(), giving.wires.end()}) +
                         " with a tolerance: take the refined method, or a tolerance of 0 and an ease.",
                     {{}, {giving.edges.begin(), giving.edges.end()}, chart.source_face});
}

FlattenError not_solvable(const Chart& chart) {
  const std::string piece = capitalized(name_piece(chart.source_face)) + " cannot be laid out in double precision";
  const std::vector<int> small = small_faces(chart);
  if (small.empty()) {
    return FlattenError(ErrorCode::not_solvable, piece + ": remesh it, or cut it in two with a seam.",
                        {{}, {}, chart.source_face});
  }
  return FlattenError(ErrorCode::not_solvable,
                      piece + ", for its faces differ too much in size: at " + name_elements("face", small) +
                          " merge vertices that lie very close together, or remesh it.",
                      {{}, {}, small});
}

FlattenError not_joined(const Chart& chart) {
  ErrorElements elements;
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind != WireKind::boundary) add_edges(chart, part.half_edges, elements.edges);
  }
  for (std::size_t i = 1; i < chart.boundary_loops.size(); ++i) {
    add_edges(chart, chart.boundary_loops[i], elements.edges);
  }
  const std::string message = "No helper wires can be laid between " + name_elements("edge", elements.edges) + " of " +
                              name_piece(chart.source_face) +
                              " in double precision: take the refined method, which needs none, or remesh the piece.";
  return FlattenError(ErrorCode::not_solvable, message, std::move(elements));
}

}  // namespace wirewarp
