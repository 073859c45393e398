// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/mirrored_cuts.h"

#include <cmath>

#include "base/disjoint_sets.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Returns twice the signed distance of each vertex from the mirror plane, in scene units.
std::vector<double> distances_across(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image) {
  OpenMesh::Vec3d across(0, 0, 0);
  std::vector<double> distances;
  for (const VertexHandle v : mesh.vertices()) {
    const OpenMesh::Vec3d apart = mesh.point(v) - mesh.point(image[v.idx()]);
    if (image[v.idx()] != v && across.norm() == 0) across = apart.normalized();
    distances.push_back(image[v.idx()] == v ? 0 : apart | across);
  }
  return distances;
}

}  // namespace

MirroredCuts::MirroredCuts(const Chart& chart, const std::vector<VertexHandle>& image)
    : mesh_(chart.mesh), is_in_plane_(chart.mesh.n_edges(), 0) {
  if (image.empty()) return;
  const std::vector<double> distances = distances_across(mesh_, image);
  for (const EdgeHandle e : mesh_.edges()) {
    const HalfedgeHandle h = mesh_.halfedge_handle(e, 0);
    const VertexHandle from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h);
    const HalfedgeHandle opposite = mesh_.find_halfedge(image[from.idx()], image[to.idx()]);
    image_.push_back(opposite.is_valid() ? mesh_.edge_handle(opposite) : e);
    has_image_.push_back(opposite.is_valid() ? 1 : 0);
    const double distance = distances[from.idx()] + distances[to.idx()];
    side_.push_back(image_.back() == e ? 0 : distance > 0 ? 1 : -1);
    is_in_plane_[e.idx()] = image[from.idx()] == from && image[to.idx()] == to && !mesh_.is_boundary(e);
  }
}

void MirroredCuts::forbid_edges_without_image(CutMask& forbidden) const {
  for (std::size_t e = 0; e < image_.size(); ++e) forbidden[e] = forbidden[e] != 0 || has_image_[e] == 0;
}

CutMask MirroredCuts::with_image(const CutMask& cut) const {
  CutMask both = cut;
  for (std::size_t e = 0; e < image_.size(); ++e) both[e] = cut[e] != 0 || cut[image_[e].idx()] != 0;
  return both;
}

std::vector<CutMask> MirroredCuts::both_ways(const CutMask& cut) const {
  if (image_.empty()) return {cut};
  std::vector<CutMask> result;
  for (const int kept : {1, -1}) {
    CutMask symmetric = cut;
    for (std::size_t e = 0; e < image_.size(); ++e) {
      if (side_[e] == -kept) symmetric[e] = cut[image_[e].idx()];
    }
    result.push_back(std::move(symmetric));
  }
  return result;
}

std::vector<CutMask> MirroredCuts::lines_in_plane() const {
  DisjointSets runs(mesh_.n_vertices());
  for (const EdgeHandle e : mesh_.edges()) {
    const HalfedgeHandle h = mesh_.halfedge_handle(e, 0);
    if (is_in_plane_[e.idx()] != 0) runs.unite(mesh_.from_vertex_handle(h).idx(), mesh_.to_vertex_handle(h).idx());
  }
  int count = 0;
  const std::vector<int> run = runs.number(count);
  std::vector<CutMask> lines{is_in_plane_};
  std::vector<int> line_of_run(static_cast<std::size_t>(count), -1);
  for (const EdgeHandle e : mesh_.edges()) {
    if (is_in_plane_[e.idx()] == 0) continue;
    int& line = line_of_run[run[mesh_.from_vertex_handle(mesh_.halfedge_handle(e, 0)).idx()]];
    if (line < 0) {
      line = static_cast<int>(lines.size());
      lines.emplace_back(mesh_.n_edges(), 0);
    }
    lines[line][e.idx()] = 1;
  }
  return lines;
}

}  // namespace wirewarp
