// SPDX-License-Identifier: GPL-3.0-or-later
// The exact evaluation of cuts along lines that cross triangles: what flatten() makes of the mesh that is cut along
// them.
#pragma once

#include <optional>
#include <vector>

#include "cuts/propose/flat_pieces.h"
#include "warp/topology/surface_path.h"
#include "wirewarp/surface_path.h"

namespace wirewarp {

/// A path on a chart, as a path on the input.
SurfacePath on_input(const FlattenInput& input, const Chart& chart, const MeshPath& path);

/// Edges of the input, one line after the other, as paths: one for each line.
std::vector<SurfacePath> paths_along(const Triangles& faces, const std::vector<VertexPair>& edges);

struct LineFigures {
  PieceFigures figures;
  double tip_strain = 0;          // of the tip with most: mean of the area around it
  std::vector<VertexPair> edges;  // of the lines, if they all run along edges
};

class LineEvaluation {
 public:
  /// piece: one of the pieces, the one that lines cut. All are kept by reference.
  LineEvaluation(const FlatPieces& pieces, std::size_t piece, const ExactEvaluation& exact);

  /// Lines from outlines to tips inside; none if they meet, if a part then has no flat shape, or if they spoil other
  /// pieces. They divide no edge on a wire or outline. In any thread. Throws Stopped.
  std::optional<LineFigures> figures_along(const std::vector<SurfacePath>& lines) const;

 private:
  const FlatPieces& pieces_;
  const std::size_t piece_;
  const ExactEvaluation& exact_;
};

}  // namespace wirewarp
