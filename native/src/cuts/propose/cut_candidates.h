// SPDX-License-Identifier: GPL-3.0-or-later
// Where a chart could be cut.
#pragma once

#include <vector>

#include "cuts/propose/smooth_paths.h"

namespace wirewarp {

enum class CutKind {
  dart,  // from the outline to a point inside
  seam,  // from the outline to the outline
};

/// A line along which to cut, given by its ends.
struct CutEnds {
  VertexHandle start;  // on the outline
  VertexHandle end;    // inside, or of a seam on the outline

  bool operator==(const CutEnds& other) const { return start == other.start && end == other.end; }
  bool operator<(const CutEnds& other) const { return start == other.start ? end < other.end : start < other.start; }
};

/// Numbers of points that cuts begin and end at.
struct CandidatePoints {
  int inside;
  int on_outline;  // half of them at corners, where there are so many
};

/// Darts: from points spread over the inside to points spread along the outline, and to where ways to it are the
/// shortest of their neighborhood. Seams in the same way, from points spread along the outline.
std::vector<CutEnds> list_candidates(const Chart& chart, const SmoothPathFinder& paths, CutKind kind,
                                     CandidatePoints count);

/// Cuts with one end moved to a neighboring vertex.
std::vector<CutEnds> neighbors_of(const Chart& chart, const SmoothPathFinder& paths, CutEnds cut);

/// Whether both ends are near those of the other: the same cut to a tailor. size: root of the chart's area.
bool are_beside(const HalfEdgeMesh& mesh, double size, CutEnds a, CutEnds b);

/// The edges of a cut, from its start. Empty where no way leads along.
HalfEdgeChain chain_of(const SmoothPathFinder& paths, CutEnds cut);

}  // namespace wirewarp
