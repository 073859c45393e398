// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/folded_faces.h"

#include <algorithm>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/overlap.h"

namespace wirewarp {
namespace {

bool is_flipped(const HalfEdgeMesh& mesh, FaceHandle f, const Positions2& uv) {
  const auto place = [&](VertexHandle v) -> Eigen::Vector2d { return uv.row(v.idx()); };
  const HalfedgeHandle h = mesh.halfedge_handle(f);
  const Eigen::Vector2d a = place(mesh.from_vertex_handle(h)), b = place(mesh.to_vertex_handle(h)),
                        c = place(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  return !(cross(b - a, c - a) > 0);
}

std::vector<int> overlapping_faces(const HalfEdgeMesh& mesh, const Positions2& uv, const StopToken& stop) {
  return find_overlapping_faces(triangles_of(mesh), faces_on_boundary(mesh), uv, kRelativeOverlapDepth, stop);
}

}  // namespace

bool has_flips(const HalfEdgeMesh& mesh, const Positions2& uv) {
  return std::any_of(mesh.faces_begin(), mesh.faces_end(), [&](FaceHandle f) { return is_flipped(mesh, f, uv); });
}

bool has_overlaps(const HalfEdgeMesh& mesh, const Positions2& uv) { return !overlapping_faces(mesh, uv, {}).empty(); }

std::vector<int> find_folded_faces(const HalfEdgeMesh& mesh, const Positions2& uv, const StopToken& stop) {
  std::vector<int> folded = overlapping_faces(mesh, uv, stop);
  for (const FaceHandle f : mesh.faces()) {
    if (is_flipped(mesh, f, uv)) folded.push_back(f.idx());
  }
  std::sort(folded.begin(), folded.end());
  folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
  return folded;
}

}  // namespace wirewarp
