// SPDX-License-Identifier: GPL-3.0-or-later
// Starts of the refined method: layouts near exact lengths.
#pragma once

#include <array>
#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

struct Start {
  const char* name;  // name in PieceReport::start
  /// Returns a layout, or nullopt if the start does not work. Throws Stopped and FactorizationFailed.
  std::optional<Shape> (*make)(Problem& problem, const Control& control);
  bool is_for_large_charts = false;             // whether small charts skip the start, which saves no time on them
  Injectivity injectivity = Injectivity::none;  // of the layout and of all later iterates
};

/// Returns the layout of WireWarping (paper II-A), which has exact lengths. It needs no factorization for the whole
/// chart. Returns nullopt if the wires do not close or helper wires cannot join them.
std::optional<Shape> flatten_wires_first(Problem& problem, const Control& control);

/// The starts in the order in which they are tried; native/README.md says how often each is successful.
extern const std::array<Start, 5> kStarts;

}  // namespace wirewarp
