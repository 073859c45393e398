// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Makes cuts of a chart symmetric that a plane mirrors onto itself.
class MirroredCuts {
 public:
  /// image: the vertex opposite to each; no entries where there is no such plane: all cuts stay as they are. Edges that
  /// have none opposite to them are opposite to themselves.
  MirroredCuts(const Chart& chart, const std::vector<VertexHandle>& image);

  CutMask with_image(const CutMask& cut) const;

  /// Forbids the edges that have none opposite to them.
  void forbid_those_without_image(CutMask& forbidden) const;

  /// What of a cut lies on the one side of the plane, and opposite to that, and what lies on the other.
  std::vector<CutMask> both_ways(const CutMask& cut) const;

  /// Runs of edges in the plane, each by itself, and all of them.
  std::vector<CutMask> lines_in_plane() const;

 private:
  const HalfEdgeMesh& mesh_;
  std::vector<EdgeHandle> image_;  // of each edge; no entries: no plane
  std::vector<int> side_;          // of each edge: -1, 1, or 0 in the plane and across it
  CutMask has_image_, is_in_plane_;
};

}  // namespace wirewarp
