// SPDX-License-Identifier: GPL-3.0-or-later
// Starts of the refined method: layouts near exact lengths.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

enum class Start {
  unfolded,  // the chart, if it is folded from a plane (newton/unfold.h); usually this is the final shape
  coarse,    // the shape of a coarser chart (newton/coarse_start.h), one to three factorizations from the minimum
  free,      // a free ARAP flattening, which is one step from exact lengths on most pieces
  /// Wires that are flattened alone, by the angles of Eq. (1) on the network of process_topology, with interior
  /// placement of the other vertices (paper II-A). It has exact lengths without a factorization of the whole chart.
  wires,
  injective,  // a shape without flips, reached without flipping any triangle (newton/injective_shape.h)
};

/// Returns PieceReport::start.
const char* name_of(Start start);

/// Returns a layout, or none if the start does not work: the chart does not unfold, or its wires do not close. Throws
/// Stopped and FactorizationFailed.
std::optional<Shape> make_start(Start start, Problem& problem, const Control& control);

}  // namespace wirewarp
