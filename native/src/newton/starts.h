// SPDX-License-Identifier: GPL-3.0-or-later
// Where the refined method may start. Each start is a layout near exact lengths, or none if it does not work. They
// throw Stopped and FactorizationFailed.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

struct Start {
  const char* name;  // PieceReport::start
  std::optional<Shape> (*make)(Problem& problem, const Control& control);
  Injectivity injectivity = Injectivity::none;  // of the start and of what is refined from it
};

/// The chart unfolded, if it is folded from a plane (newton/unfold.h): mostly nothing is left to do.
std::optional<Shape> unfolded(Problem& problem, const Control& control);

/// The shape of a coarser chart (newton/coarse_start.h): one to three factorizations from the end.
std::optional<Shape> coarse_shape(Problem& problem, const Control& control);

/// A free ARAP flattening: one step from exact lengths on most pieces.
std::optional<Shape> free_shape(Problem& problem, const Control& control);

/// The wires flattened alone: the angles of Eq. (1) on the network that process_topology prepares, the other vertices
/// by interior placement (paper II-A). It has exact lengths without a factorization of the whole chart. None if even
/// the wires do not close.
std::optional<Shape> wires_alone(Problem& problem, const Control& control);

/// A shape without flipped triangles, reached without flipping any (newton/injective_shape.h).
std::optional<Shape> injective_shape(Problem& problem, const Control& control);

}  // namespace wirewarp
