// SPDX-License-Identifier: GPL-3.0-or-later
#include "metrics/guarantee.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "errors/sentence.h"
#include "mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kRelativeLengthError = 1e-9;

/// A wire edge whose planar length is not the promised one.
struct WrongEdge {
  VertexPair vertices;  // input
  int part;             // index into chart.wire_parts, -1 boundary
  double difference;    // (l2 - (1+r)(1+h) l) / l
};

std::vector<WrongEdge> find_wrong_edges(const Chart& chart, const WireNetwork& network, const Positions2& uv,
                                        const std::vector<double>& variation) {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * uv.cwiseAbs().maxCoeff();
  std::vector<WrongEdge> wrong;
  for (const WireEdge& edge : network.edges) {
    const int part = edge.part;
    if (part >= 0 && chart.wire_parts[part].kind == WireKind::super_elastic) continue;
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edge.edge, 0);
    const double promised =
        part < 0 ? edge.length : (1 + variation[part]) / (1 + chart.wire_parts[part].ease) * edge.length;
    const double length_3d = edge_length(chart.mesh, h);
    const double difference = planar_length(chart.mesh, h, uv) - promised;
    if (std::abs(difference) <= kRelativeLengthError * length_3d + rounding) continue;
    wrong.push_back({source_edge(chart, h), part, difference / length_3d});
  }
  // The worst first, so that a message that names a few names these.
  std::stable_sort(wrong.begin(), wrong.end(), [](const WrongEdge& a, const WrongEdge& b) {
    return std::abs(a.difference) > std::abs(b.difference);
  });
  return wrong;
}

std::vector<int> parts_beyond_tolerance(const Chart& chart, const std::vector<double>& variation) {
  std::vector<int> parts;
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    const bool is_bounded = part.kind == WireKind::elastic || gives_on_boundary(part);
    if (is_bounded && !(variation[i] >= part.ease - part.tolerance && variation[i] <= part.ease + part.tolerance)) {
      parts.push_back(static_cast<int>(i));
    }
  }
  return parts;
}

std::string name_part(const Chart& chart, const std::vector<Wire>& wires, int part) {
  return part < 0 ? "the outline" : name_wires(wires, {chart.wire_parts[part].wire_index});
}

std::string count(std::size_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

/// ", has 3 flipped faces and overlaps itself at 1 face" and the like, for the promises that the error is not about.
std::string also(std::size_t flipped, std::size_t overlapping) {
  const std::string flips = "has " + count(flipped, "flipped face");
  const std::string overlaps = "overlaps itself at " + count(overlapping, "face");
  if (flipped > 0 && overlapping > 0) return ", " + flips + " and " + overlaps;
  return flipped > 0 ? ", and " + flips : overlapping > 0 ? ", and " + overlaps : "";
}

FlattenError wrong_lengths(const Chart& chart, const std::vector<Wire>& wires, const std::vector<WrongEdge>& wrong,
                           const std::vector<int>& beyond, const Metrics& metrics) {
  ErrorElements elements;
  for (const WrongEdge& edge : wrong) elements.edges.push_back(edge.vertices);
  for (const int part : beyond) {
    for (const HalfedgeHandle h : chart.wire_parts[part].half_edges) {
      elements.edges.push_back(source_edge(chart, h));
    }
  }
  std::string what;
  if (!wrong.empty()) {
    const WrongEdge& worst = wrong.front();
    what = "The piece does not keep the length of " + name_elements("edge", elements.edges) + " (the first, on " +
           name_part(chart, wires, worst.part) + ", is " + percent(worst.difference) + " too " +
           (worst.difference > 0 ? "long)" : "short)");
  } else {
    const int part = beyond.front();
    what = "The piece stretches " + name_part(chart, wires, part) + " beyond its tolerance of " +
           percent(chart.wire_parts[part].tolerance);
  }
  what += also(metrics.flipped_faces.size(), metrics.overlapping_faces.size());
  return FlattenError(ErrorCode::lengths_not_kept,
                      what + ": add a seam where the piece curves most" +
                          (has_wires(chart) ? ", or give its wires more tolerance." : "."),
                      std::move(elements), true);
}

/// A piece that lies over itself: seams are proposed, or else done as the remedy says.
FlattenError folded(ErrorCode code, const std::vector<int>& faces, const std::vector<VertexPair>& proposed_seams,
                    const std::string& what, const std::string& remedy) {
  const std::string seams = proposed_seams.empty() ? "" : "mark seams" + such_as_along(proposed_seams) + ", or ";
  return FlattenError(code, what + ": " + seams + remedy, {{}, {}, faces, proposed_seams}, true);
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
    const std::string loosen = has_wires(chart) ? ", or remove or loosen a wire nearby." : ".";
    return folded(ErrorCode::flipped_faces, metrics.flipped_faces, proposed_seams,
                  "The piece is turned over at " + name_elements("face", metrics.flipped_faces) +
                      also(0, metrics.overlapping_faces.size()),
                  "add a seam or a dart there" + loosen);
  }
  if (!metrics.overlapping_faces.empty()) {
    return folded(ErrorCode::overlapping_faces, metrics.overlapping_faces, proposed_seams,
                  "The piece covers itself at " + name_elements("face", metrics.overlapping_faces),
                  "cut it in two with a seam, or add a dart there.");
  }
  return std::nullopt;
}

}  // namespace wirewarp
