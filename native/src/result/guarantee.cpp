// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/guarantee.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/arguments.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kRelativeLengthError = 1e-9;  // the guarantee in docs/guarantees.md

/// A wire edge with a planar length that breaks the guarantee.
struct WrongEdge {
  VertexPair vertices;  // vertices of the input
  int part;             // index into chart.wire_parts; -1: boundary
  double difference;    // excess over the guaranteed length, divided by the length on the surface
};

std::vector<WrongEdge> find_wrong_edges(const Chart& chart, const WireNetwork& network, const Positions2& uv,
                                        const std::vector<double>& variation) {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * uv.cwiseAbs().maxCoeff();
  std::vector<WrongEdge> wrong;
  for (const WireEdge& edge : network.edges) {
    const int part = edge.part;
    if (part >= 0 && chart.wire_parts[part].kind == WireKind::super_elastic) continue;
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edge.edge, 0);
    const double guaranteed =
        part < 0 ? edge.length : (1 + variation[part]) / (1 + chart.wire_parts[part].ease) * edge.length;
    const double length_3d = edge_length(chart.mesh, h);
    const double difference = planar_length(chart.mesh, h, uv) - guaranteed;
    if (std::abs(difference) <= kRelativeLengthError * length_3d + rounding) continue;
    wrong.push_back({source_edge(chart, h), part, difference / length_3d});
  }
  // The worst edge comes first, because a message names only the first few edges.
  std::stable_sort(wrong.begin(), wrong.end(), [](const WrongEdge& a, const WrongEdge& b) {
    return std::abs(a.difference) > std::abs(b.difference);
  });
  return wrong;
}

std::vector<int> parts_beyond_tolerance(const Chart& chart, const std::vector<double>& variation) {
  std::vector<int> parts;
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    const bool is_bounded = part.kind == WireKind::elastic || is_elastic_boundary(part);
    if (is_bounded && !(variation[i] >= part.ease - part.tolerance && variation[i] <= part.ease + part.tolerance)) {
      parts.push_back(static_cast<int>(i));
    }
  }
  return parts;
}

ErrorArguments arguments_of_part(const Chart& chart, const std::vector<Wire>& wires, int part) {
  return arguments_of_wires(wires, part < 0 ? std::vector<int>() : std::vector<int>{chart.wire_parts[part].wire_index});
}

int count(const std::vector<int>& faces) { return static_cast<int>(faces.size()); }

FlattenError wrong_lengths(const Chart& chart, const std::vector<Wire>& wires, const std::vector<WrongEdge>& wrong,
                           const std::vector<int>& beyond, const Metrics& metrics) {
  ErrorElements elements;
  for (const WrongEdge& edge : wrong) elements.edges.push_back(edge.vertices);
  for (const int part : beyond) {
    for (const HalfedgeHandle h : chart.wire_parts[part].half_edges) {
      elements.edges.push_back(source_edge(chart, h));
    }
  }
  const int part = wrong.empty() ? beyond.front() : wrong.front().part;
  ErrorArguments arguments = arguments_of_part(chart, wires, part);
  if (wrong.empty()) {
    arguments["tolerance"] = chart.wire_parts[part].tolerance;
  } else {
    arguments["difference"] = wrong.front().difference;
  }
  arguments["num_flipped"] = count(metrics.flipped_faces);
  arguments["num_overlapping"] = count(metrics.overlapping_faces);
  arguments["has_wires"] = has_wires(chart);
  return FlattenError(ErrorCode::lengths_not_kept, std::move(arguments), std::move(elements), true);
}

}  // namespace

std::optional<FlattenError> check_guarantee(const Chart& chart, const WireNetwork& network,
                                            const std::vector<Wire>& wires, const Positions2& uv,
                                            const std::vector<double>& variation, const Metrics& metrics,
                                            const std::vector<VertexPair>& proposed_seams) {
  const std::vector<WrongEdge> wrong = find_wrong_edges(chart, network, uv, variation);
  const std::vector<int> beyond = parts_beyond_tolerance(chart, variation);
  if (!wrong.empty() || !beyond.empty()) return wrong_lengths(chart, wires, wrong, beyond, metrics);

  if (!metrics.flipped_faces.empty()) {
    return FlattenError(
        ErrorCode::flipped_faces,
        ErrorArguments{{"num_overlapping", count(metrics.overlapping_faces)}, {"has_wires", has_wires(chart)}},
        {{}, {}, metrics.flipped_faces, proposed_seams}, true);
  }
  if (!metrics.overlapping_faces.empty()) {
    return FlattenError(ErrorCode::overlapping_faces, ErrorArguments{},
                        {{}, {}, metrics.overlapping_faces, proposed_seams}, true);
  }
  return std::nullopt;
}

}  // namespace wirewarp
