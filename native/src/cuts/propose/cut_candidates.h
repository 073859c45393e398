// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/smooth_paths.h"

namespace wirewarp {

enum class CutKind {
  dart,  // from the outline to a point inside
  seam,  // from the outline to the outline
};

struct CutEnds {
  VertexHandle start;  // on the outline
  VertexHandle end;    // inside; for a seam, on the outline

  bool operator==(const CutEnds& other) const { return start == other.start && end == other.end; }
  bool operator<(const CutEnds& other) const { return start == other.start ? end < other.end : start < other.start; }
};

struct CandidatePoints {
  int inside;
  int on_outline;  // half of them at corners, if there are enough corners
};

/// Returns cuts to points spread over the inside (darts) or along the outline (seams). They start at points spread
/// along the outline, or at landings: points with cheaper paths than all points nearby.
std::vector<CutEnds> list_candidates(const Chart& chart, const SmoothPathFinder& paths, CutKind kind,
                                     CandidatePoints count);

/// Returns variants of a cut, each with one end moved to a neighboring vertex.
std::vector<CutEnds> neighbors_of(const Chart& chart, const SmoothPathFinder& paths, CutEnds cut);

/// Returns whether the ends of two cuts are so near each other that a tailor would see one cut. size: √area of the
/// chart.
bool are_beside(const HalfEdgeMesh& mesh, double size, CutEnds a, CutEnds b);

/// Returns the edges of a cut from its start to its end; empty if no path exists.
HalfEdgeChain chain_of(const SmoothPathFinder& paths, CutEnds cut);

}  // namespace wirewarp
