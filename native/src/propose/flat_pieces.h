// SPDX-License-Identifier: GPL-3.0-or-later
// The exact evaluation of cuts: what flatten() makes of the pieces that a cut changes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "charts/chart.h"
#include "feasibility/part_map.h"
#include "internal_options.h"
#include "stop_token.h"

namespace wirewarp {

/// One piece of a flattened input.
struct FlatPiece {
  Chart chart;    // its sources are the input's vertices and faces
  PartMap edges;  // of the chart
  std::optional<FlattenError> error;
  double energy = 0;          // Eq. (4), or of the cloth, scene units squared
  double strain = 0;          // DartProposal::strain
  std::vector<double> areas;  // per face, scene units squared
  Eigen::VectorXd strains;    // per face: max(sigma_1, 1/sigma_2) - 1
};

/// All pieces of an input, as flatten() numbers them. Pieces that no further cut changes are shared.
using FlatPieces = std::vector<std::shared_ptr<const FlatPiece>>;

/// Figures of a piece, or of all its parts together; none but the error if one of them has an error.
struct PieceFigures {
  double energy = 0;  // over the 3D area
  double strain = 0;  // DartProposal::strain
  double area = 0;    // in 3D, scene units squared
  std::optional<FlattenError> error;
};

/// The figures of those pieces that are made of faces of a chart.
PieceFigures figures_of(const FlatPieces& pieces, const Chart& chart);

/// Whether a chart is made of faces of another one. Both have their sources in the input, in increasing order.
bool is_part_of(const Chart& part, const Chart& chart);

/// The pieces that have one of these edges on their outline.
FlatPieces pieces_beside(const FlatPieces& pieces, const std::vector<VertexPair>& edges);

class ExactEvaluation {
 public:
  /// input: checked, in the middle of its material, kept by reference. stop: polled in any thread.
  ExactEvaluation(const FlattenInput& input, const InternalOptions& options, StopToken stop);

  /// The input along its own seams. Throws Stopped.
  FlatPieces uncut() const;

  /// The same with edges as further seams, and without some seams: only the pieces that these run through or lie beside
  /// are flattened, those coupled with them by elastic seams, and where a cloth is stretched their neighbors, which
  /// share the lengths of seams. In any thread. Throws Stopped.
  FlatPieces with_cut(const FlatPieces& before, const std::vector<VertexPair>& edges,
                      const std::vector<VertexPair>& opened = {}) const;

  /// The error of a piece, with the seams or tolerances that flatten() proposes. Throws Stopped.
  FlattenError explain(const FlatPieces& pieces, int piece) const;

  const FlattenInput& input() const { return input_; }
  const InternalOptions& options() const { return options_; }
  const StopToken& stop() const { return stop_; }

 private:
  struct Selection;

  Selection coupled(const FlatPieces& pieces, Selection chosen) const;
  Selection with_neighbors(const FlatPieces& pieces, const Selection& chosen) const;
  FlattenResult flatten_along_seams(const Charts& charts, const InternalOptions& options) const;
  FlatPieces flatten_along_seams(Charts charts) const;
  Charts cut_chosen(const FlatPieces& pieces, const Selection& chosen, const std::vector<VertexPair>& edges,
                    const std::vector<VertexPair>& opened) const;

  const FlattenInput& input_;
  InternalOptions options_;
  StopToken stop_;
};

}  // namespace wirewarp
