// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates cuts along lines that cross triangles: cuts the mesh along the lines, and flattens it as flatten() does.
#pragma once

#include <optional>
#include <vector>

#include "cuts/propose/flat_pieces.h"
#include "warp/topology/surface_path.h"
#include "wirewarp/cut_mesh.h"
#include "wirewarp/propose.h"
#include "wirewarp/surface_path.h"

namespace wirewarp {

/// Converts a path on a chart to a path on the input.
SurfacePath on_input(const FlattenInput& input, const Chart& chart, const MeshPath& path);

/// Converts edges of the input, listed line after line, to one path for each line.
std::vector<SurfacePath> paths_along(const Triangles& faces, const std::vector<VertexPair>& edges);

struct LineFigures {
  PieceFigures figures;
  double tip_strain = 0;          // mean strain around the most strained tip
  std::vector<VertexPair> edges;  // edges of the lines; empty if a line crosses a triangle
};

/// A surface that cut_mesh() has divided along the lines of a cut, with its pieces before and after the cut.
class CutSurface {
 public:
  /// Throws Stopped.
  /// - piece: index of the piece that is cut
  /// - exact: evaluation on the original mesh
  /// - cut: must outlive the object
  CutSurface(const FlatPieces& pieces, std::size_t piece, const ExactEvaluation& exact, const CutMesh& cut);

  const ExactEvaluation& exact() const { return exact_; }
  const FlatPieces& before() const { return before_; }
  const FlatPieces& after() const { return after_; }

  /// Returns the chart of the piece before the cut.
  const Chart& chart() const { return before_[piece_]->chart; }

  /// Returns the edges of the cut if they are all edges of the input, otherwise none.
  std::vector<VertexPair> edges() const;

  /// Returns the length of the cut in scene units, measured in the middle of the material's thickness.
  double length() const;

 private:
  const CutMesh& cut_;
  const std::size_t piece_;
  const bool has_new_vertices_;
  const FlattenInput input_;
  const SurfaceToCut surface_;
  const ExactEvaluation exact_;
  FlatPieces before_, after_;
};

/// Returns a copy of a cut set with the lines `paths`. surface: the surface that is cut along these lines. figures:
/// figures of the cut piece.
DartProposal with_lines(DartProposal set, std::vector<SurfacePath> paths, const CutSurface& surface,
                        const PieceFigures& figures);

/// Returns the figures of a piece with cuts along lines, each from an outline to a tip inside. Throws Stopped.
/// - Returns nullopt if lines meet, a part has no flat shape, or other pieces get worse.
/// - Lines must not divide an edge of a wire or outline.
/// - Any thread may call this function.
std::optional<LineFigures> figures_with_lines(const FlatPieces& pieces, std::size_t piece,
                                              const std::vector<SurfacePath>& lines, const ExactEvaluation& exact);

}  // namespace wirewarp
