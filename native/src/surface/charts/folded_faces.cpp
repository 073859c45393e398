// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/folded_faces.h"

#include <algorithm>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/overlap.h"

namespace wirewarp {

std::vector<int> find_folded_faces(const HalfEdgeMesh& mesh, const Positions2& uv) {
  const Triangles triangles = triangles_of(mesh);
  std::vector<int> folded = find_overlapping_faces(triangles, faces_on_boundary(mesh), uv);
  for (int f = 0; f < triangles.rows(); ++f) {
    const Eigen::Vector2d a = uv.row(triangles(f, 0)), b = uv.row(triangles(f, 1)), c = uv.row(triangles(f, 2));
    if (!(cross(b - a, c - a) > 0)) folded.push_back(f);
  }
  std::sort(folded.begin(), folded.end());
  folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
  return folded;
}

}  // namespace wirewarp
