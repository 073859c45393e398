// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "cuts/propose/flat_pieces.h"
#include "cuts/propose/surface_lines.h"
#include "wirewarp/propose.h"

namespace wirewarp {

struct PieceToCut {
  const FlatPieces& pieces;  // all pieces of the input
  std::size_t index;
  const Chart& chart;                      // in canonical order
  const std::vector<VertexHandle>& image;  // mirror image of each vertex, or empty
};

struct SmoothLimits {
  double most_strain;
  double most_bends = std::numeric_limits<double>::infinity();  // largest share of the original bends that may remain
  int num_narrow = std::numeric_limits<int>::max();             // largest number of narrow parts, see count_narrow()
  // If the strain of a part exceeds most_strain by this factor, all lines around the part, not only one, become less
  // smooth at once. This saves evaluations, but leaves more bends.
  double far_too_much = std::numeric_limits<double>::infinity();
};

/// Returns a cut set whose lines are as smooth as the limits allow; nullopt if no smoother lines are allowed. set: the
/// set before smoothing, with the same number of pieces. Throws Stopped.
std::optional<DartProposal> smooth_lines(const DartProposal& set, const SurfaceLines& lines, const SmoothLimits& limits,
                                         const PieceToCut& piece, const CutOptions& cut_options,
                                         const ExactEvaluation& exact);

/// Returns a set with smoother lines instead of edges, or `set` if no smoother lines are allowed. The smooth set has at
/// most the strain `most_strain`, and at most twice the strain of `set`. Throws Stopped.
DartProposal smooth_set(const DartProposal& set, double most_strain, const FlatPieces& pieces, std::size_t piece,
                        const CutOptions& cut_options, const ExactEvaluation& exact);

}  // namespace wirewarp
