// SPDX-License-Identifier: GPL-3.0-or-later
// Where the refined method may begin. Each start is a layout near exact lengths, or none where it does not serve.
#pragma once

#include <optional>

#include "inner/inner_problem.h"
#include "refine/refine_shape.h"
#include "refine/relax_lengths.h"
#include "stop_token.h"

namespace wirewarp {

/// A chart to refine, and what its starts share.
struct StartProblem {
  RefineTask task;
  RefineBudget& budget;
  StopToken stop;
  std::size_t large_chart = 0;                // faces, from which on a coarser chart is a start
  std::optional<Positions2> free_shape = {};  // once it was asked for
  std::optional<RelaxedShape> relaxed = {};   // once it was made
  InnerSolution inner = {};                   // of the wires alone, once they were flattened
};

struct Start {
  const char* name;  // PieceReport::start
  std::optional<RefinementStart> (*make)(StartProblem& problem);
  Injectivity injectivity = Injectivity::none;  // of the start and of what is refined from it
};

/// The chart unfolded, if it is folded from a plane (refine/unfold.h): mostly nothing is left to do.
std::optional<RefinementStart> unfolded(StartProblem& problem);

/// The shape of a coarser chart, for one of large_chart faces or more (refine/coarse_start.h): one to three
/// factorizations from the end.
std::optional<RefinementStart> coarse_shape(StartProblem& problem);

/// A free ARAP flattening: one step from exact lengths on most pieces.
std::optional<RefinementStart> free_shape(StartProblem& problem);

/// The wires flattened alone: the angles of Eq. (1) on the network that process_topology prepares, the other vertices
/// by interior placement (paper II-A). It has exact lengths; none where even the wires do not close, or no topology
/// serves them.
std::optional<RefinementStart> wires_alone(StartProblem& problem);

/// A shape that no triangle is turned over in, reached without turning any (refine/injective_shape.h).
std::optional<RefinementStart> injective_shape(StartProblem& problem);

/// The shape that breaks lengths at the least price (refine/relax_lengths.h), where it finds that they can be kept: of
/// 1,000 random charts 2 begin here, nets of short wires that the other starts are too far from.
std::optional<RefinementStart> relaxed_shape(StartProblem& problem);

}  // namespace wirewarp
