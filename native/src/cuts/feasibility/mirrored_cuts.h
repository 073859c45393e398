// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Makes cuts of a chart symmetric if a plane mirrors the chart onto itself.
class MirroredCuts {
 public:
  /// image: mirror image of each vertex; empty if there is no plane. Without a plane, cuts do not change. An edge
  /// without a mirror image counts as its own image.
  MirroredCuts(const Chart& chart, const std::vector<VertexHandle>& image);

  CutMask with_image(const CutMask& cut) const;

  void forbid_edges_without_image(CutMask& forbidden) const;

  /// Returns two symmetric cuts. Each consists of the cut's edges on one side of the plane, of their mirror images, and
  /// of the edges that are their own images. Without a plane, returns the given cut alone.
  std::vector<CutMask> both_ways(const CutMask& cut) const;

  /// Returns one cut along all inner edges in the plane, then one cut along each connected run of these edges.
  std::vector<CutMask> lines_in_plane() const;

 private:
  const HalfEdgeMesh& mesh_;
  std::vector<EdgeHandle> image_;  // mirror image of each edge; empty without a plane
  std::vector<int> side_;          // side of the plane for each edge: -1 or 1; 0 if the edge is its own image
  CutMask has_image_, is_in_plane_;
};

}  // namespace wirewarp
