// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/open_further.h"

#include "feasibility/isoperimetric.h"
#include "feasibility/shortest_paths.h"
#include "index.h"

namespace wirewarp {
namespace {

/// One piece is good enough if it has what a hemisphere has; a ball cut in two halves can have no more.
constexpr double kEnough = 0.5;

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

/// Straightens the border between two sides: a face that has two edges on it changes sides, for the third is shorter.
void take_off_teeth(const HalfEdgeMesh& mesh, std::vector<char>& is_on_second_side) {
  std::vector<FaceHandle> queue;
  for (const FaceHandle f : mesh.faces()) queue.push_back(f);
  while (!queue.empty()) {
    const FaceHandle f = queue.back();
    queue.pop_back();
    std::vector<FaceHandle> across;
    for (const FaceHandle other : mesh.ff_range(f)) {
      if (is_on_second_side[at(other.idx())] != is_on_second_side[at(f.idx())]) across.push_back(other);
    }
    if (across.size() != 2) continue;
    is_on_second_side[at(f.idx())] = !is_on_second_side[at(f.idx())];
    for (const FaceHandle other : mesh.ff_range(f)) queue.push_back(other);
  }
}

/// The border between the faces nearer to one vertex and those nearer to the other.
CutMask cut_between(const HalfEdgeMesh& mesh, VertexHandle first, VertexHandle second) {
  const std::vector<double> from_first = shortest_paths(mesh, {first}).distance;
  const std::vector<double> from_second = shortest_paths(mesh, {second}).distance;
  std::vector<char> is_on_second_side(mesh.n_faces(), 0);
  for (const FaceHandle f : mesh.faces()) {
    double lead = 0;
    for (const VertexHandle v : mesh.fv_range(f)) lead += from_first[at(v.idx())] - from_second[at(v.idx())];
    is_on_second_side[at(f.idx())] = lead > 0;
  }
  take_off_teeth(mesh, is_on_second_side);
  CutMask cut(mesh.n_edges(), 0);
  for (const EdgeHandle e : mesh.edges()) {
    if (mesh.is_boundary(e)) continue;
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    cut[at(e.idx())] =
        is_on_second_side[at(mesh.face_handle(h).idx())] != is_on_second_side[at(mesh.opposite_face_handle(h).idx())];
  }
  return cut;
}

}  // namespace

CutMask slit_to_far_end(const HalfEdgeMesh& mesh) {
  const std::vector<VertexHandle> sources = starts(mesh);
  const ShortestPaths paths = shortest_paths(mesh, sources);
  const std::vector<HalfedgeHandle> path = path_back(mesh, paths, farthest_vertex(paths));
  CutMask cut(mesh.n_edges(), 0);
  // Both sides of a single edge inside a closed surface would be one loop of two edges between the same vertices.
  if (path.size() == 1 && !mesh.is_boundary(sources.front())) return cut;
  for (const HalfedgeHandle h : path) cut[at(mesh.edge_handle(h).idx())] = 1;
  return cut;
}

CutMask opened_or_halved(const HalfEdgeMesh& mesh, const CutMask& opening) {
  const std::vector<PieceOutline> opened = outlines_after(mesh, opening);
  if (attainable_share(opened.front()) >= kEnough) return opening;
  // Two far ends of the surface, and two more that lie apart across it.
  const VertexHandle first = farthest_from(mesh, starts(mesh));
  const VertexHandle second = farthest_from(mesh, {first});
  const VertexHandle third = farthest_from(mesh, {first, second});
  const VertexHandle fourth = farthest_from(mesh, {third});
  CutMask best = opening;
  double best_fitness = fitness(opened);
  for (const CutMask& cut : {cut_between(mesh, first, second), cut_between(mesh, third, fourth)}) {
    const double cut_fitness = fitness(outlines_after(mesh, cut));
    if (cut_fitness <= best_fitness) continue;
    best_fitness = cut_fitness;
    best = cut;
  }
  return best;
}

}  // namespace wirewarp
