// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces that a chart falls into along cut edges: their areas and the loops of their outlines.
#pragma once

#include <vector>

#include "mesh/half_edge_mesh.h"

namespace wirewarp {

/// Edges to cut along, one flag per edge of a chart's mesh.
using CutMask = std::vector<char>;

struct OutlineLoop {
  double length = 0;     // scene units
  HalfedgeHandle start;  // one of its half-edges, the piece on the left
};

struct PieceOutline {
  double area = 0;                 // scene units squared
  std::vector<OutlineLoop> loops;  // the longest first
};

/// One for each connected region between cut edges.
std::vector<PieceOutline> outlines_after(const HalfEdgeMesh& mesh, const CutMask& cut);

/// Length of all cut edges, scene units.
double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut);

}  // namespace wirewarp
