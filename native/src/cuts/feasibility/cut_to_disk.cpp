// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/cut_to_disk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/disjoint_sets.h"
#include "cuts/feasibility/ranks.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/shortest_paths.h"

namespace wirewarp {
namespace {

/// Number of base points on a closed surface. The search tries one cut through each base point, and returns the
/// shortest. Of three closed tori, two get other cut sets with 4 points, but only one with 16.
constexpr int kBasePoints = 8;

/// Lengths of cuts count as equal if they differ by less than this share. Detours (see edges_left_over()) count as
/// equal if they differ by less than this share of the longest path. So rotating the mesh does not change the choice.
constexpr double kTie = 1e-9;

/// Returns the inner edges that neither `paths` nor a tree of faces uses: two per handle, and one per boundary loop
/// after the first. Leaves out forbidden and unreachable edges.
std::vector<EdgeHandle> edges_left_over(const HalfEdgeMesh& mesh, const CutMask& forbidden,
                                        const ShortestPaths& paths) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<char> is_in_tree(mesh.n_edges(), 0);
  for (const HalfedgeHandle h : paths.arrival) {
    if (h.is_valid()) is_in_tree[mesh.edge_handle(h).idx()] = 1;
  }
  std::vector<EdgeHandle> edges;
  std::vector<double> detours;
  for (const EdgeHandle e : mesh.edges()) {
    if (mesh.is_boundary(e) || is_in_tree[e.idx()]) continue;
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    // The detour leads from the sources to one end, along the edge, and from the other end back to the sources.
    const double detour = paths.distance[mesh.from_vertex_handle(h).idx()] + edge_length(mesh, h) +
                          paths.distance[mesh.to_vertex_handle(h).idx()];
    edges.push_back(e);
    detours.push_back(forbidden[e.idx()] != 0 ? kInfinity : detour);
  }
  DisjointSets faces(mesh.n_faces());
  // The tree of faces crosses edges with long detours first, so edges with short detours are left over.
  std::vector<EdgeHandle> left_over;
  for (const std::size_t i : highest_first(detours, kTie * paths.distance[farthest_vertex(paths).idx()])) {
    const HalfedgeHandle h = mesh.halfedge_handle(edges[i], 0);
    const bool is_joined = faces.unite(mesh.face_handle(h).idx(), mesh.opposite_face_handle(h).idx());
    if (!is_joined && std::isfinite(detours[i])) left_over.push_back(edges[i]);
  }
  return left_over;
}

/// Removes cuts that end inside the surface, because such cuts open nothing.
void prune(const HalfEdgeMesh& mesh, CutMask& cut) {
  std::vector<VertexHandle> queue;
  for (const VertexHandle v : mesh.vertices()) queue.push_back(v);
  while (!queue.empty()) {
    const VertexHandle v = queue.back();
    queue.pop_back();
    std::vector<HalfedgeHandle> cuts;
    for (const HalfedgeHandle h : mesh.voh_range(v)) {
      if (cut[mesh.edge_handle(h).idx()]) cuts.push_back(h);
    }
    if (cuts.size() != 1 || mesh.is_boundary(v)) continue;
    cut[mesh.edge_handle(cuts[0]).idx()] = 0;
    queue.push_back(mesh.to_vertex_handle(cuts[0]));
  }
}

CutMask cut_through(const HalfEdgeMesh& mesh, const CutMask& forbidden, const std::vector<VertexHandle>& sources) {
  const ShortestPaths paths = shortest_paths(mesh, sources, around(mesh, forbidden));
  CutMask cut(mesh.n_edges(), 0);
  for (const EdgeHandle e : edges_left_over(mesh, forbidden, paths)) {
    cut[e.idx()] = 1;
    for (const unsigned end : {0u, 1u}) {
      for (const HalfedgeHandle h : path_back(mesh, paths, mesh.to_vertex_handle(mesh.halfedge_handle(e, end)))) {
        cut[mesh.edge_handle(h).idx()] = 1;
      }
    }
  }
  prune(mesh, cut);
  return cut;
}

}  // namespace

CutMask cut_to_disk(const HalfEdgeMesh& mesh, const CutMask& forbidden) {
  const std::vector<VertexHandle> boundary = boundary_vertices(mesh);
  if (!boundary.empty()) return cut_through(mesh, forbidden, boundary);

  std::vector<VertexHandle> bases{VertexHandle(0)};
  CutMask best;
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kBasePoints; ++i) {
    bases.push_back(farthest_vertex(shortest_paths(mesh, bases, around(mesh, forbidden))));
    CutMask cut = cut_through(mesh, forbidden, {bases.back()});
    const double length = length_of_cut(mesh, cut);
    if (length > (1 - kTie) * shortest) continue;
    shortest = length;
    best = std::move(cut);
  }
  return best;
}

}  // namespace wirewarp
