// SPDX-License-Identifier: GPL-3.0-or-later
// Starts of the refined method: layouts near exact lengths.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

enum class Start {
  unfolded,  // the unfolded chart, if it is developable (newton/unfold.h); usually the final shape
  coarse,    // the shape of a coarser chart (newton/coarse_start.h), 1 to 3 factorizations from the minimum
  free,      // a free ARAP flattening; on most pieces, one step from there reaches exact lengths
  /// WireWarping: flattens the wires alone by the angles of Eq. (1) on the network of process_topology, then places the
  /// other vertices (paper II-A). Has exact lengths without a factorization for the whole chart.
  wires,
  injective,  // a shape without flips, reached without flipping any triangle (newton/injective_shape.h)
};

/// Returns PieceReport::start.
const char* name_of(Start start);

/// Returns a layout, or nullopt if the start does not work: the chart does not unfold, or its wires do not close.
/// Throws Stopped and FactorizationFailed.
std::optional<Shape> make_start(Start start, Problem& problem, const Control& control);

}  // namespace wirewarp
