// SPDX-License-Identifier: GPL-3.0-or-later
// Where the refined method may begin. Each start is a layout near exact lengths, or none where it does not serve.
#pragma once

#include <optional>

#include "newton/refine_shape.h"
#include "newton/start_problem.h"

namespace wirewarp {

struct Start {
  const char* name;  // PieceReport::start
  std::optional<RefinementStart> (*make)(StartProblem& problem);
  Injectivity injectivity = Injectivity::none;  // of the start and of what is refined from it
};

/// The chart unfolded, if it is folded from a plane (newton/unfold.h): mostly nothing is left to do.
std::optional<RefinementStart> unfolded(StartProblem& problem);

/// The shape of a coarser chart, for one of large_chart faces or more (newton/coarse_start.h): one to three
/// factorizations from the end.
std::optional<RefinementStart> coarse_shape(StartProblem& problem);

/// A free ARAP flattening: one step from exact lengths on most pieces.
std::optional<RefinementStart> free_shape(StartProblem& problem);

/// The wires flattened alone: the angles of Eq. (1) on the network that process_topology prepares, the other vertices
/// by interior placement (paper II-A). It has exact lengths at no factorization of the whole chart. None
/// where even the wires do not close, or no topology serves them.
std::optional<RefinementStart> wires_alone(StartProblem& problem);

/// A shape without flipped triangles, reached without flipping any (newton/injective_shape.h).
std::optional<RefinementStart> injective_shape(StartProblem& problem);

}  // namespace wirewarp
