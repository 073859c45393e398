// SPDX-License-Identifier: GPL-3.0-or-later
// The funnel algorithm: unfolds the strip into the plane and pulls a string through the crossed edges.
#include <algorithm>
#include <cmath>

#include "surface/mesh/geometry.h"
#include "warp/topology/strip.h"

namespace wirewarp {
namespace {

/// A crossed edge in the plane, and its open part, which the path may cross. The gates at both ends of the strip are
/// points.
struct Gate {
  Planar from;
  Planar to;
  double first_t = 0;  // right end of the open part
  double last_t = 1;   // left end of the open part

  Planar point(double t) const { return from + t * (to - from); }
  Planar right() const { return first_t == 0 ? from : point(first_t); }
  Planar left() const { return last_t == 1 ? to : point(last_t); }
};

std::vector<Gate> unfold(const HalfEdgeMesh& mesh, const WireMask& wires, const Strip& strip) {
  // If an end of a crossed edge is on a wire, the path keeps away from this end by this share of the edge. This leaves
  // room for triangles between path and wire. The share is above kNearVertex, so the path does not snap to the wire.
  constexpr double kKeptAway = 0.25;
  Planar from = 0;
  Planar to = edge_length(mesh, strip.crossings.front());
  Planar apex = apex_over(mesh, strip.crossings.front());
  std::vector<Gate> gates{{apex, apex}};
  for (std::size_t i = 0; i < strip.crossings.size(); ++i) {
    const HalfedgeHandle h = strip.crossings[i];
    if (i > 0) {
      const HalfedgeHandle entry = mesh.opposite_halfedge_handle(strip.crossings[i - 1]);  // leads from `to` to `from`
      (h == mesh.next_halfedge_handle(entry) ? to : from) = apex;
    }
    gates.push_back({from, to, wires.has(mesh.from_vertex_handle(h)) ? kKeptAway : 0,
                     wires.has(mesh.to_vertex_handle(h)) ? 1 - kKeptAway : 1});
    apex = to + (from - to) / std::abs(from - to) * apex_over(mesh, mesh.opposite_halfedge_handle(h));
  }
  gates.push_back({apex, apex});
  return gates;
}

/// A corner of the path, which is a taut string. The corner is an end of all gates from first_gate to last_gate.
struct Corner {
  Planar point;
  std::size_t first_gate = 0;
  std::size_t last_gate = 0;
  bool is_left = false;
};

void add_corner(std::vector<Corner>& corners, Planar point, std::size_t gate, bool is_left) {
  if (corners.back().point == point) {
    corners.back().last_gate = gate;
  } else {
    corners.push_back({point, gate, gate, is_left});
  }
}

/// Returns the corners of the shortest path through all gates, including both ends.
std::vector<Corner> pull_string(const std::vector<Gate>& gates) {
  struct Side {
    Planar point;
    std::size_t gate;
  };
  Side tip{gates.front().from, 0};
  Side left = tip;
  Side right = tip;
  std::vector<Corner> corners{{tip.point, 0, 0, false}};
  const auto start_again_at = [&](const Side& corner, bool is_left) {
    add_corner(corners, corner.point, corner.gate, is_left);
    tip = corner;
    left = right = tip;
    return tip.gate;
  };
  for (std::size_t i = 1; i < gates.size(); ++i) {
    const Planar new_right = gates[i].right();
    if (cross(right.point - tip.point, new_right - tip.point) >= 0) {
      const bool is_open = right.point == tip.point || cross(left.point - tip.point, new_right - tip.point) < 0;
      if (!is_open) {
        i = start_again_at(Side(left), true);
        continue;
      }
      right = {new_right, i};
    }
    const Planar new_left = gates[i].left();
    if (cross(left.point - tip.point, new_left - tip.point) <= 0) {
      const bool is_open = left.point == tip.point || cross(right.point - tip.point, new_left - tip.point) > 0;
      if (!is_open) {
        i = start_again_at(Side(right), false);
        continue;
      }
      left = {new_left, i};
    }
  }
  add_corner(corners, gates.back().from, gates.size() - 1, false);
  return corners;
}

/// Returns the parameter along a gate at which the line from a to b crosses the gate.
double crossing_parameter(const Gate& gate, Planar a, Planar b) {
  const Planar along = gate.to - gate.from;
  const double left = cross(b - a, gate.to - a);
  const double right = cross(gate.from - a, b - a);
  // If the sum is 0, the line runs along the gate.
  const double t =
      left + right > 0 ? right / (left + right) : std::real(std::conj(along) * (a - gate.from)) / std::norm(along);
  return std::clamp(t, gate.first_t, gate.last_t);
}

}  // namespace

StripPath shortest_in_strip(const HalfEdgeMesh& mesh, const WireMask& wires, const Strip& strip) {
  const PathPoint start = PathPoint::at_vertex(strip.start);
  const PathPoint end = PathPoint::at_vertex(strip.end);
  if (strip.crossings.empty()) return {{start, end}, path_length(mesh, {start, end}), {}};

  const std::vector<Gate> gates = unfold(mesh, wires, strip);
  const std::vector<Corner> corners = pull_string(gates);
  StripPath result{{start}, 0, {}};
  std::size_t gate = 1;
  for (std::size_t c = 1; c < corners.size(); ++c) {
    const Corner& corner = corners[c];
    const Planar before = corners[c - 1].point;
    result.length += std::abs(corner.point - before);
    for (; gate <= corner.last_gate && gate + 1 < gates.size(); ++gate) {
      double t = crossing_parameter(gates[gate], before, corner.point);
      if (gate >= corner.first_gate) t = corner.is_left ? gates[gate].last_t : gates[gate].first_t;
      result.path.push_back(PathPoint::on_edge(strip.crossings[gate - 1], t));
    }
    if (c + 1 == corners.size()) break;
    const Gate& at_corner = gates[corner.first_gate];
    if (corner.is_left ? at_corner.last_t < 1 : at_corner.first_t > 0) continue;  // inside the edge, not at a vertex
    const HalfedgeHandle h = strip.crossings[corner.first_gate - 1];
    const double angle = std::abs(std::arg((corners[c + 1].point - corner.point) / (corner.point - before)));
    result.turns.push_back({corner.first_gate - 1,
                            corner.is_left ? mesh.to_vertex_handle(h) : mesh.from_vertex_handle(h), corner.is_left,
                            angle});
  }
  result.path.push_back(end);
  return result;
}

}  // namespace wirewarp
