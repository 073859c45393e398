// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/forbidden_lines.h"

#include <algorithm>

#include "surface/charts/chart.h"

namespace wirewarp {
namespace {

/// Barycentric coordinates below this value count as zero: far above rounding errors, and far below the width of a
/// sewable piece of a triangle.
constexpr double kOnEdge = 1e-9;

std::set<VertexPair> sorted_set(const VertexPairs& pairs) {
  std::set<VertexPair> set;
  for (const auto& ends : pairs.rowwise()) set.insert(sorted({ends[0], ends[1]}));
  return set;
}

}  // namespace

ForbiddenLines::ForbiddenLines(const CutOptions& cut_options, const Triangles& faces)
    : faces_(faces), no_seam_(sorted_set(cut_options.no_seam)), no_crossing_(sorted_set(cut_options.no_crossing)) {}

bool ForbiddenLines::contains(const SurfacePath& path) const {
  int last = -1;  // the vertex at the last point; -1 if it is not at a vertex
  for (std::size_t i = 0; i < path.faces.size(); ++i) {
    std::vector<int> corners;  // of the edge or face that contains the point
    for (int k = 0; k < 3; ++k) {
      if (path.coordinates(static_cast<Eigen::Index>(i), k) > kOnEdge) corners.push_back(faces_(path.faces[i], k));
    }
    if (corners.size() == 2) {
      const VertexPair edge = sorted({corners[0], corners[1]});
      if (no_seam_.count(edge) + no_crossing_.count(edge) > 0) return true;
    }
    const int vertex = corners.size() == 1 ? corners.front() : -1;
    if (vertex >= 0 && last >= 0 && no_seam_.count(sorted({last, vertex})) > 0) return true;
    last = vertex;
  }
  return false;
}

bool ForbiddenLines::contain_any(const std::vector<SurfacePath>& paths) const {
  return std::any_of(paths.begin(), paths.end(), [&](const SurfacePath& path) { return contains(path); });
}

}  // namespace wirewarp
