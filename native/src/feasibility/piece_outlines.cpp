// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/piece_outlines.h"

#include <algorithm>

#include "disjoint_sets.h"
#include "mesh/geometry.h"

namespace wirewarp {
namespace {

bool is_outline(const HalfEdgeMesh& mesh, const CutMask& cut, HalfedgeHandle h) {
  const EdgeHandle e = mesh.edge_handle(h);
  return mesh.is_boundary(e) || cut[e.idx()] != 0;
}

/// The outline's next half-edge around the piece.
HalfedgeHandle next_on_outline(const HalfEdgeMesh& mesh, const CutMask& cut, HalfedgeHandle h) {
  h = mesh.next_halfedge_handle(h);
  while (!is_outline(mesh, cut, h)) h = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
  return h;
}

}  // namespace

std::vector<PieceOutline> outlines_after(const HalfEdgeMesh& mesh, const CutMask& cut) {
  DisjointSets regions(mesh.n_faces());
  for (const EdgeHandle e : mesh.edges()) {
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    if (is_outline(mesh, cut, h)) continue;
    regions.unite(mesh.face_handle(h).idx(), mesh.opposite_face_handle(h).idx());
  }
  int count = 0;
  const std::vector<int> region = regions.number(count);
  std::vector<PieceOutline> pieces(count);
  for (const FaceHandle f : mesh.faces()) pieces[region[f.idx()]].area += face_area(mesh, f);

  std::vector<char> is_seen(mesh.n_halfedges(), 0);
  for (const HalfedgeHandle start : mesh.halfedges()) {
    if (mesh.is_boundary(start) || is_seen[start.idx()] || !is_outline(mesh, cut, start)) continue;
    OutlineLoop loop{0, start};
    for (HalfedgeHandle h = start; !is_seen[h.idx()]; h = next_on_outline(mesh, cut, h)) {
      is_seen[h.idx()] = 1;
      loop.length += edge_length(mesh, h);
    }
    pieces[region[mesh.face_handle(start).idx()]].loops.push_back(loop);
  }
  for (PieceOutline& piece : pieces) {
    std::stable_sort(piece.loops.begin(), piece.loops.end(),
                     [](const OutlineLoop& a, const OutlineLoop& b) { return a.length > b.length; });
  }
  return pieces;
}

double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut) {
  double length = 0;
  for (const EdgeHandle e : mesh.edges()) {
    if (cut[e.idx()]) length += edge_length(mesh, mesh.halfedge_handle(e, 0));
  }
  return length;
}

}  // namespace wirewarp
