// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/strip.h"

#include <algorithm>
#include <unordered_map>

#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

bool touches(const HalfEdgeMesh& mesh, HalfedgeHandle h, VertexHandle v) {
  return mesh.from_vertex_handle(h) == v || mesh.to_vertex_handle(h) == v;
}

bool face_has(const HalfEdgeMesh& mesh, HalfedgeHandle h, VertexHandle v) {
  return touches(mesh, h, v) || mesh.to_vertex_handle(mesh.next_halfedge_handle(h)) == v;
}

/// Removes the crossings between two visits of the same triangle.
std::vector<HalfedgeHandle> without_detours(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& crossings) {
  std::vector<HalfedgeHandle> kept;
  if (crossings.empty()) return kept;
  std::vector<int> faces{mesh.face_handle(crossings.front()).idx()};
  std::unordered_map<int, std::size_t> position{{faces.front(), 0}};
  for (const HalfedgeHandle h : crossings) {
    const int face = mesh.face_handle(mesh.opposite_halfedge_handle(h)).idx();
    const auto seen = position.find(face);
    if (seen == position.end()) {
      kept.push_back(h);
      position[face] = faces.size();
      faces.push_back(face);
      continue;
    }
    const std::size_t first = seen->second;
    kept.resize(first);
    for (std::size_t i = first + 1; i < faces.size(); ++i) position.erase(faces[i]);
    faces.resize(first + 1);
  }
  return kept;
}

/// Removes detours, so that the strip visits each triangle once and has one triangle at each end vertex.
Strip shorten(const HalfEdgeMesh& mesh, Strip strip) {
  strip.crossings = without_detours(mesh, strip.crossings);
  std::vector<HalfedgeHandle>& crossings = strip.crossings;
  const auto last_at_start = std::find_if(crossings.rbegin(), crossings.rend(), [&](HalfedgeHandle h) {
    return face_has(mesh, mesh.opposite_halfedge_handle(h), strip.start);
  });
  crossings.erase(crossings.begin(), last_at_start.base());
  const auto first_at_end =
      std::find_if(crossings.begin(), crossings.end(), [&](HalfedgeHandle h) { return face_has(mesh, h, strip.end); });
  crossings.erase(first_at_end, crossings.end());
  return strip;
}

/// The half-edges around a center between two given half-edges, counter-clockwise, and the angle between these two.
struct Fan {
  std::vector<HalfedgeHandle> between;
  double angle = 0;
};

Fan fan_between(const HalfEdgeMesh& mesh, HalfedgeHandle first, HalfedgeHandle last) {
  Fan fan;
  for (HalfedgeHandle h = first; h != last; h = next_counterclockwise(mesh, h)) {
    if (h != first) fan.between.push_back(h);
    fan.angle += corner_angle(mesh, h);
  }
  return fan;
}

}  // namespace

Strip strip_beside(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& edge_path) {
  Strip strip{edge_path.front(), edge_path.back(), {}};
  bool was_left = false;
  for (std::size_t i = 1; i + 1 < edge_path.size(); ++i) {
    const HalfedgeHandle back = mesh.find_halfedge(edge_path[i], edge_path[i - 1]);
    const HalfedgeHandle ahead = mesh.find_halfedge(edge_path[i], edge_path[i + 1]);
    Fan left = fan_between(mesh, ahead, back);
    const Fan right = fan_between(mesh, back, ahead);
    const bool is_left = left.angle <= right.angle;
    if (i > 1 && is_left != was_left) {  // the strip changes sides, so it crosses an edge of the path
      strip.crossings.push_back(was_left ? mesh.opposite_halfedge_handle(back) : back);
    }
    was_left = is_left;
    if (is_left) {
      strip.crossings.insert(strip.crossings.end(), left.between.rbegin(), left.between.rend());
    } else {
      for (const HalfedgeHandle h : right.between) strip.crossings.push_back(mesh.opposite_halfedge_handle(h));
    }
  }
  return shorten(mesh, std::move(strip));
}

Strip pass_on_other_side(const HalfEdgeMesh& mesh, const Strip& strip, const StripTurn& turn) {
  const auto is_at_vertex = [&](std::size_t i) { return touches(mesh, strip.crossings[i], turn.vertex); };
  std::size_t begin = turn.crossing;
  while (begin > 0 && is_at_vertex(begin - 1)) --begin;
  std::size_t end = turn.crossing + 1;
  while (end < strip.crossings.size() && is_at_vertex(end)) ++end;

  const auto before = strip.crossings.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto after = strip.crossings.begin() + static_cast<std::ptrdiff_t>(end);
  Strip other{strip.start, strip.end, {strip.crossings.begin(), before}};
  const FaceHandle last = mesh.face_handle(mesh.opposite_halfedge_handle(*(after - 1)));
  // The strip runs counter-clockwise around a vertex on its left, so its replacement runs clockwise.
  const auto beside = [&](HalfedgeHandle h) {
    return turn.is_left ? mesh.next_halfedge_handle(h) : mesh.prev_halfedge_handle(h);
  };
  HalfedgeHandle h = beside(*before);
  other.crossings.push_back(h);
  while (mesh.face_handle(mesh.opposite_halfedge_handle(h)) != last) {
    h = beside(mesh.opposite_halfedge_handle(h));
    other.crossings.push_back(h);
  }
  other.crossings.insert(other.crossings.end(), after, strip.crossings.end());
  return shorten(mesh, std::move(other));
}

}  // namespace wirewarp
