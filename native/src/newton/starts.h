// SPDX-License-Identifier: GPL-3.0-or-later
// Starts of the refined method. Each one is a layout near exact lengths, or none if it does not work. They throw
// Stopped and FactorizationFailed.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

struct Start {
  const char* name;  // PieceReport::start
  std::optional<Shape> (*make)(Problem& problem, const Control& control);
  Injectivity injectivity = Injectivity::none;  // required of the start and of shapes refined from it
};

/// Returns the unfolded chart if it is folded from a plane (newton/unfold.h); usually this is the final shape.
std::optional<Shape> unfolded(Problem& problem, const Control& control);

/// Returns the shape of a coarser chart (newton/coarse_start.h), which is one to three factorizations from the minimum.
std::optional<Shape> coarse_shape(Problem& problem, const Control& control);

/// Returns a free ARAP flattening, which is one step from exact lengths on most pieces.
std::optional<Shape> free_shape(Problem& problem, const Control& control);

/// Returns wires that are flattened alone, by the angles of Eq. (1) on the network of process_topology, with interior
/// placement of the other vertices (paper II-A). This has exact lengths without a factorization of the whole chart.
/// None if even the wires do not close.
std::optional<Shape> wires_alone(Problem& problem, const Control& control);

/// Returns a shape without flipped triangles, reached without flipping any (newton/injective_shape.h).
std::optional<Shape> injective_shape(Problem& problem, const Control& control);

}  // namespace wirewarp
