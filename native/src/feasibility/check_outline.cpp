// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/check_outline.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "errors/sentence.h"
#include "feasibility/isoperimetric.h"
#include "mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr std::size_t kMostNamed = 5;

PieceOutline outline_of(const Chart& chart) {
  PieceOutline outline{surface_area(chart.mesh), {}};
  for (const HalfEdgeChain& chain : chart.boundary_loops) {
    outline.loops.push_back({length_of(chart.mesh, chain), chain.front()});
  }
  std::stable_sort(outline.loops.begin(), outline.loops.end(),
                   [](const OutlineLoop& a, const OutlineLoop& b) { return a.length > b.length; });
  return outline;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

int source_of_loop(const Chart& chart, const OutlineLoop& loop) {
  return chart.source_vertex[chart.mesh.from_vertex_handle(loop.start).idx()];
}

std::string name_loop(const Chart& chart, const OutlineLoop& loop) {
  return number(loop.length) + " units long at " +
         name_elements("vertex", std::vector<int>{source_of_loop(chart, loop)});
}

/// The longest few: "its outline, 0.4 units long at vertex 3," or "its outlines, 0.4 units long at vertex 3 and 0.2
/// units long at vertex 7,".
std::string name_outlines(const Chart& chart, const std::vector<OutlineLoop>& loops) {
  std::string names = loops.size() == 1 ? "its outline, " : "its outlines, ";
  const std::size_t num_named = std::min(loops.size(), kMostNamed);
  for (std::size_t i = 0; i < num_named; ++i) {
    names += (i == 0 ? "" : i + 1 == loops.size() ? " and " : ", ") + name_loop(chart, loops[i]);
  }
  if (num_named < loops.size()) names += " and " + std::to_string(loops.size() - num_named) + " more";
  return names + ",";
}

std::string what_to_do(std::size_t num_loops) {
  if (num_loops == 1) return "cannot lie flat: mark another seam";
  if (num_loops == 2) return "is a tube: mark a seam from one opening to the other";
  return "cannot lie flat: mark seams between its " + std::to_string(num_loops) + " openings";
}

}  // namespace

bool is_outline_too_short(const Chart& chart) {
  const PieceOutline outline = outline_of(chart);
  return isoperimetric_ratio(outline) < required_share(outline.loops.size());
}

FlattenError outline_too_short(const Chart& chart, std::vector<VertexPair> proposed_seams) {
  const PieceOutline outline = outline_of(chart);
  const double share = isoperimetric_ratio(outline);
  ErrorElements elements;
  for (const OutlineLoop& loop : outline.loops) elements.vertices.push_back(source_of_loop(chart, loop));
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) elements.edges.push_back(source_edge(chart, h));
  }
  elements.faces = chart.source_face;
  const std::string message =
      "The piece around face " + std::to_string(chart.source_face.front()) + " (" +
      std::to_string(chart.source_face.size()) + " triangles) " + what_to_do(outline.loops.size()) +
      such_as_along(proposed_seams) + "; " + name_outlines(chart, outline.loops) + " can hold no more than " +
      percent(share) + " of its area in the plane (a distortion of at least " + number(least_shape_error(share)) + ").";
  elements.proposed_seams = std::move(proposed_seams);
  return FlattenError(ErrorCode::boundary_too_short, message, std::move(elements));
}

}  // namespace wirewarp
