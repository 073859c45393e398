// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/open_further.h"

#include <algorithm>
#include <utility>

#include "feasibility/isoperimetric.h"
#include "mesh/geometry.h"
#include "mesh/shortest_paths.h"

namespace wirewarp {
namespace {

/// What a hemisphere has, made of coarse triangles: a ball cut in two halves can have no more.
constexpr double kEnough = 0.45;

VertexHandle farthest_from(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& sources) {
  return farthest_vertex(shortest_paths(mesh, sources));
}

/// Where slits may begin: all of the boundary, or a far end of a closed surface.
std::vector<VertexHandle> starts(const HalfEdgeMesh& mesh) {
  std::vector<VertexHandle> boundary;
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_boundary(v)) boundary.push_back(v);
  }
  return boundary.empty() ? std::vector<VertexHandle>{farthest_from(mesh, {VertexHandle(0)})} : boundary;
}

bool is_border(const HalfEdgeMesh& mesh, const std::vector<char>& side, HalfedgeHandle h) {
  if (mesh.is_boundary(mesh.edge_handle(h))) return false;
  return side[mesh.face_handle(h).idx()] != side[mesh.opposite_face_handle(h).idx()];
}

/// By how much the border between two sides grows if all faces around a vertex go to one side.
double growth_of_border(const HalfEdgeMesh& mesh, const std::vector<char>& side, VertexHandle v, char to) {
  double growth = 0;
  for (const HalfedgeHandle spoke : mesh.voh_range(v)) {
    if (is_border(mesh, side, spoke)) growth -= edge_length(mesh, spoke);
    if (mesh.is_boundary(spoke) || side[mesh.face_handle(spoke).idx()] == to) continue;
    const HalfedgeHandle rim = mesh.next_halfedge_handle(spoke);
    if (mesh.is_boundary(mesh.edge_handle(rim))) continue;
    growth += is_border(mesh, side, rim) ? -edge_length(mesh, rim) : edge_length(mesh, rim);
  }
  return growth;
}

/// Straightens the border: moves it over a vertex wherever that makes it shorter.
void shorten_border(const HalfEdgeMesh& mesh, std::vector<char>& side) {
  constexpr double kRounding = 1e-12;  // of the longest edge there
  std::vector<VertexHandle> queue(mesh.vertices_begin(), mesh.vertices_end());
  while (!queue.empty()) {
    const VertexHandle v = queue.back();
    queue.pop_back();
    double longest = 0;
    for (const HalfedgeHandle spoke : mesh.voh_range(v)) longest = std::max(longest, edge_length(mesh, spoke));
    for (const char to : {char{0}, char{1}}) {
      if (growth_of_border(mesh, side, v, to) >= -kRounding * longest) continue;
      for (const FaceHandle f : mesh.vf_range(v)) side[f.idx()] = to;
      for (const VertexHandle near : mesh.vv_range(v)) queue.push_back(near);
    }
  }
}

/// Which faces are nearer to the second vertex than to the first.
std::vector<char> divide(const HalfEdgeMesh& mesh, VertexHandle first, VertexHandle second) {
  const std::vector<double> from_first = shortest_paths(mesh, {first}).distance;
  const std::vector<double> from_second = shortest_paths(mesh, {second}).distance;
  std::vector<char> side(mesh.n_faces(), 0);
  for (const FaceHandle f : mesh.faces()) {
    double lead = 0;
    for (const VertexHandle v : mesh.fv_range(f)) lead += from_first[v.idx()] - from_second[v.idx()];
    side[f.idx()] = lead > 0;
  }
  return side;
}

CutMask cut_along_border(const HalfEdgeMesh& mesh, const std::vector<char>& side) {
  CutMask cut(mesh.n_edges(), 0);
  for (const EdgeHandle e : mesh.edges()) cut[e.idx()] = is_border(mesh, side, mesh.halfedge_handle(e, 0));
  return cut;
}

/// The smaller, the better: short cuts among those that leave outline enough, the rest by how much outline they leave.
std::pair<double, double> rank(const HalfEdgeMesh& mesh, const CutMask& cut) {
  const double enough = kEnough / required_share(1);
  return {-std::min(enough, worst_margin(outlines_after(mesh, cut))), length_of_cut(mesh, cut)};
}

}  // namespace

CutMask slit_to_far_end(const HalfEdgeMesh& mesh) {
  const std::vector<VertexHandle> sources = starts(mesh);
  const ShortestPaths paths = shortest_paths(mesh, sources);
  const std::vector<HalfedgeHandle> path = path_back(mesh, paths, farthest_vertex(paths));
  CutMask cut(mesh.n_edges(), 0);
  // Both sides of a single edge inside a closed surface would be one loop of two edges between the same vertices.
  if (path.size() == 1 && !mesh.is_boundary(sources.front())) return cut;
  for (const HalfedgeHandle h : path) cut[mesh.edge_handle(h).idx()] = 1;
  return cut;
}

CutMask opened_or_halved(const HalfEdgeMesh& mesh, const CutMask& opening) {
  if (isoperimetric_ratio(outlines_after(mesh, opening).front()) >= kEnough) return opening;
  // Two far ends of the surface, and two more that lie apart across it.
  const VertexHandle first = farthest_from(mesh, starts(mesh));
  const VertexHandle second = farthest_from(mesh, {first});
  const VertexHandle third = farthest_from(mesh, {first, second});
  const VertexHandle fourth = farthest_from(mesh, {third});
  std::vector<CutMask> cuts{opening};
  for (std::vector<char> side : {divide(mesh, first, second), divide(mesh, third, fourth)}) {
    cuts.push_back(cut_along_border(mesh, side));  // where there are few faces, it vanishes as it gets shorter
    shorten_border(mesh, side);
    cuts.push_back(cut_along_border(mesh, side));
  }
  return *std::min_element(cuts.begin(), cuts.end(),
                           [&](const CutMask& a, const CutMask& b) { return rank(mesh, a) < rank(mesh, b); });
}

}  // namespace wirewarp
