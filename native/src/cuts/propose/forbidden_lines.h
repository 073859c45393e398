// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "wirewarp/propose.h"

namespace wirewarp {

/// The edges that CutOptions forbids for the lines of a set.
class ForbiddenLines {
 public:
  /// faces: kept by reference.
  ForbiddenLines(const CutOptions& cut_options, const Triangles& faces);

  /// Returns whether a path crosses one of the edges, or follows one of CutOptions::no_seam. A path that only passes
  /// through a vertex of such an edge, or that runs around forbidden faces, is allowed.
  bool contains(const SurfacePath& path) const;
  bool contain_any(const std::vector<SurfacePath>& paths) const;

 private:
  const Triangles& faces_;
  std::set<VertexPair> no_seam_, no_crossing_;  // sorted
};

}  // namespace wirewarp
